#include "window/app.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "window/actions.h"
#include "window/camera_motion.h"
#include "window/files.h"
#include "window/moving.h"
#include "window/panels/panels.h"
#include "window/playing.h"

namespace hsr::window {
namespace {

constexpr float letters = 16.0F;  ///< height in pixels at scale 1
constexpr float lecture_scale = 1.4F;

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Uint32 register_event() {
  const Uint32 type = SDL_RegisterEvents(1);
  return type == static_cast<Uint32>(-1) ? Uint32{SDL_USEREVENT} : type;
}

void push_event(Uint32 type) {
  SDL_Event event = {};
  event.type = type;
  SDL_PushEvent(&event);
}

}  // namespace

App::App(Extent size, bool hidden, int threads)
    : window_("hidden-surface kit", size, hidden),
      bridge_(window_),
      wake_event_(register_event()),
      session_([type = wake_event_] { push_event(type); }, threads),
      ui_(session_.bench, recorder_) {
  session_.renderer = window_.renderer();
}

bool App::restless() const {
  return animating_ || bridge_.has_more() || session_.bench.settling() || !held_.empty() ||
         ImGui::GetIO().WantTextInput;
}

int App::longest_wait() const {
  constexpr int minute = 60000;
  constexpr int look = static_cast<int>(1000.0 * FileWatch::interval);
  return session_.bench.watched_file() ? look : minute;
}

void App::run() {
  // ImGui needs a frame or two after an event until all has settled.
  constexpr int frames_after_event = 3;
  int frames = frames_after_event;
  while (!session_.quit) {
    const bool working = session_.bench.busy() || session_.has_message();
    const int wait = frames > 0 || restless() ? 0 : working ? 50 : longest_wait();
    if (wait > 0 && SDL_WaitEventTimeout(nullptr, wait) != 0) frames = frames_after_event;
    if (SDL_HasEvents(SDL_FIRSTEVENT, SDL_LASTEVENT)) frames = frames_after_event;
    const double start = seconds_now();
    frame();
    SDL_RenderPresent(window_.renderer());
    frames = std::max(frames - 1, 0);
    // A display that does not wait for its refresh must not be drawn on as fast as possible.
    constexpr double shortest = 1.0 / 62.0;
    const double left = shortest - (seconds_now() - start);
    if (left > 0.0) SDL_Delay(static_cast<Uint32>(1000.0 * left));
  }
}

void App::frame() {
  SDL_Event event;
  while (SDL_PollEvent(&event) != 0) take(event);
  const double now = seconds_now();
  const double passed = last_frame_ > 0.0 ? std::min(now - last_frame_, 0.1) : 1.0 / 60.0;
  last_frame_ = now;
  session_.now += passed;
  fly(passed);
  play(session_, passed);
  follow_window_size();
  set_fonts();
  move_parameter(session_, passed);
  session_.bench.update(session_.now, session_.picture_room);
  if (const auto news = session_.bench.gif_news()) session_.tell(*news);
  bridge_.begin_frame(static_cast<float>(passed));
  ImGui::NewFrame();
  recorder_.words.clear();
  recorder_.places.clear();
  draw_panels();
  ImGui::Render();
  SDL_SetRenderDrawColor(window_.renderer(), 0, 0, 0, 255);
  SDL_RenderClear(window_.renderer());
  bridge_.draw(*ImGui::GetDrawData());
  SDL_RenderFlush(window_.renderer());  // without it frames that are never presented would pile up
  if (std::exchange(session_.screenshot, false)) save_window(session_, window_);
  session_.frame_times.add(1000.0 * (seconds_now() - now));
  animating_ = session_.bench.state.comparing == Comparing::blink || session_.playing ||
               session_.moving_parameter >= 0;
}

void App::follow_window_size() {
  std::optional<Extent>& wanted = session_.bench.state.window;
  if (wanted && *wanted != window_size_) window_.resize(*wanted);  // a state that was read wants another one
  window_size_ = window_.size();
  wanted = window_size_;
}

void App::take(const SDL_Event& event) {
  bridge_.take(event, session_.panel_keys);
  switch (event.type) {
    case SDL_QUIT:
      session_.quit = true;
      break;
    case SDL_KEYDOWN:
    case SDL_KEYUP:
      take_key(event);
      break;
    case SDL_DROPFILE:
      if (event.drop.file != nullptr) session_.bench.open_scene(event.drop.file);
      SDL_free(event.drop.file);
      break;
    case SDL_WINDOWEVENT:
      if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) held_.clear();
      break;
    default:
      break;
  }
}

void App::take_key(const SDL_Event& event) {
  const SDL_Keycode key = event.key.keysym.sym;
  if (event.type == SDL_KEYUP) {
    held_.erase(key);
    return;
  }
  if (ImGui::GetIO().WantTextInput) return;
  const unsigned modifiers = event.key.keysym.mod;
  const bool leaves_panels = key == SDLK_TAB || key == SDLK_ESCAPE || key == SDLK_F1;
  if (session_.panel_keys && !leaves_panels) return;
  if (run_action(session_, key, modifiers)) return;
  constexpr std::array flying = {SDLK_w, SDLK_a, SDLK_s, SDLK_d, SDLK_q, SDLK_e};
  if ((modifiers & (KMOD_CTRL | KMOD_ALT)) == 0 && std::ranges::find(flying, key) != flying.end())
    held_.insert(key);
}

void App::fly(double seconds) {
  if (held_.empty() || !session_.bench.model()) return;
  const auto axis = [this](SDL_Keycode more, SDL_Keycode less) {
    return (held_.contains(more) ? 1.0 : 0.0) - (held_.contains(less) ? 1.0 : 0.0);
  };
  const glm::dvec3 way(axis(SDLK_d, SDLK_a), axis(SDLK_e, SDLK_q), axis(SDLK_w, SDLK_s));
  // Across the scene in about four seconds.
  const double speed = 0.5 * std::max(session_.bench.model()->sphere.radius, 1e-9);
  if (way != glm::dvec3(0.0))
    session_.bench.move_camera(flown(session_.bench.camera(), seconds * speed * way));
}

void App::set_fonts() {
  const State& state = session_.bench.state;
  const float scale =
      (state.scale > 0.0F ? state.scale : window_.display_scale()) * (state.lecture ? lecture_scale : 1.0F);
  const float em = std::round(letters * scale);
  const bool same_style = em == loaded_em_ && styled_ == state.theme && styled_lecture_ == state.lecture;
  if (same_style) return;
  if (em != loaded_em_) {
    ui_.fonts = load_fonts(em);
    bridge_.upload_fonts();
  }
  apply_style(state.theme, em, state.lecture);
  loaded_em_ = em;
  styled_ = state.theme;
  styled_lecture_ = state.lecture;
  ui_.em = em;
  ui_.stroke = std::max(1.0F, std::round(em / letters * (state.lecture ? 1.5F : 1.0F)));
  ui_.palette = palette_of(state.theme);
}

void App::draw_panels() {
  const State& state = session_.bench.state;
  ImGuiIO& io = ImGui::GetIO();
  if (session_.panel_keys) {
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  } else {
    io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
  }
  LayoutWishes wishes = {ui_.em, !state.lecture, true, state.stepping, state.lesson != 0, state.lesson_aside};
  const Layout layout = lay_out(io.DisplaySize, wishes);
  // The picture has the same pixels whether steps are shown below it or not.
  wishes.steps = false;
  const ImVec2 room = lay_out(io.DisplaySize, wishes).picture.size;
  session_.picture_room = {static_cast<int>(room.x), static_cast<int>(room.y)};
  session_.bench.want_skip_times(false);  // unless a panel asks
  draw_bar(ui_, session_, layout.bar);
  if (layout.lesson.size.x > 0.0F) draw_lesson_panel(ui_, session_, layout.lesson);
  if (layout.left.size.x > 0.0F) draw_settings(layout.left);
  draw_picture(ui_, session_, layout.picture);
  if (layout.right.size.x > 0.0F) draw_pixel_panel(ui_, session_, layout.right);
  if (layout.steps.size.y > 0.0F) draw_steps_panel(ui_, session_, layout.steps);
  draw_status(ui_, session_, layout.status);
  draw_lesson_list(ui_, session_);
  draw_key_card(ui_, session_);
}

void App::draw_settings(const Area& area) {
  State& state = session_.bench.state;
  ui_.begin_panel("settings", area.corner, area.size);
  if (state.lesson != 0 && state.lesson_aside && ui_.button("Back to the lesson")) state.lesson_aside = false;
  if (ui_.heading("Scene")) draw_scene_panel(ui_, session_);
  if (ui_.heading("Algorithm")) draw_algorithm_panel(ui_, session_);
  if (ui_.heading("Compare and check")) draw_compare_panel(ui_, session_);
  if (ui_.heading("Work")) draw_work_panel(ui_, session_);
  ui_.end_panel();
}

}  // namespace hsr::window
