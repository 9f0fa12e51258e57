#include "window/workbench.h"

#include <algorithm>
#include <utility>

namespace hsr::window {
namespace {

/// How long the camera must rest before a picture in full size is begun.
constexpr double rest_seconds = 0.15;

}  // namespace

Workbench::Workbench(std::function<void()> wake, int threads)
    : threads_(threads),
      model_lane_(wake),
      file_lane_(wake),
      picture_lane_(wake),
      other_lane_(wake),
      truth_lane_(wake),
      judgement_lane_(wake),
      causes_lane_(wake),
      story_lane_(wake, Pace::keeps_up),
      trace_lane_(wake),
      moment_lane_(wake, Pace::keeps_up),
      marks_lane_(wake),
      lengths_lane_(wake),
      overdraw_lane_(wake),
      structure_lane_(wake),
      skips_lane_(wake),
      gif_lane_(wake) {}

void Workbench::update(double seconds, Extent panel) {
  now_ = seconds;
  if (panel.width > 0 && panel.height > 0) fit_panel(panel);
  if (model_lane_.poll() && model_lane_.result_key()->moved.empty()) {
    unmoved_ = model()->scene;
    unmoved_name_ = model_lane_.result_key()->scene;
  }
  (void)file_lane_.poll();
  if (picture_lane_.poll()) {
    ++pictures_made_;
    if (picture_lane_.result_key()->view.size == picture_size()) full_ms_ = picture()->render_ms;
  }
  (void)other_lane_.poll();
  (void)truth_lane_.poll();
  (void)judgement_lane_.poll();
  (void)causes_lane_.poll();
  (void)story_lane_.poll();
  (void)trace_lane_.poll();
  (void)moment_lane_.poll();
  (void)marks_lane_.poll();
  (void)lengths_lane_.poll();
  (void)overdraw_lane_.poll();
  (void)structure_lane_.poll();
  (void)skips_lane_.poll();
  poll_gif();
  settling_ = now_ - camera_moved_ < rest_seconds;
  want_model();
  if (!model()) return;
  find_home_camera();
  if (!model_is_current()) return;
  watch_file();
  want_pictures();
  want_truth();
  want_steps();
  want_extras();
}

bool Workbench::model_is_current() const {
  return model() && model_lane_.result_key() == ModelKey{state.scene, state.moved};
}

void Workbench::fit_panel(Extent panel) {
  if (!state.picture && state.pixel && panel != panel_ && fitted_) {
    // The same place of the scene, nearly: it is seen at the same part of the picture's height.
    const double factor = static_cast<double>(panel.height) / panel_.height;
    const double x = panel.width / 2.0 + factor * (state.pixel->x + 0.5 - panel_.width / 2.0);
    const double y = factor * (state.pixel->y + 0.5);
    state.pixel = glm::ivec2(std::clamp(static_cast<int>(x), 0, panel.width - 1),
                             std::clamp(static_cast<int>(y), 0, panel.height - 1));
  }
  panel_ = panel;
  fitted_ = true;
}

void Workbench::want_model() {
  ModelKey key = {state.scene, state.moved};
  if (unmoved_name_ != key.scene) key.moved.clear();  // what is to be moved must be there first
  model_lane_.want(key, key.moved.empty(), [&] {
    const auto unmoved = key.moved.empty() ? nullptr : unmoved_;
    return [key, unmoved, number = ++models_](const Progress& progress) {
      return make_model(key, number, unmoved, progress);
    };
  });
}

void Workbench::want_truth() {
  const bool needed = state.check || (state.comparing != Comparing::off && !state.other);
  if (!needed || settling_ || !picture_is_current()) return;
  const ViewKey view = view_key();
  truth_lane_.want(view, true, [&] {
    return [view, given = surroundings()](const Progress& progress) {
      return find_truth(view, given, progress);
    };
  });
  if (!truth()) return;
  judgement_lane_.want(picture_key(), true, [&] {
    return [rendered = picture(), exact = truth()](const Progress& progress) {
      return judge(*rendered, *exact, progress);
    };
  });
  want_causes();
}

void Workbench::want_causes() {
  const auto found = judgement();
  if (!found || !state.check) return;
  if (found->failed.empty() && !found->colors_differ()) return;
  causes_lane_.want(picture_key(), true, [&] {
    return [key = picture_key(), given = surroundings(), rendered = picture(), exact = truth()](
               const Progress& progress) { return find_causes(key, given, *rendered, *exact, progress); };
  });
}

std::shared_ptr<const OrderingFailures> Workbench::causes() const {
  if (!judgement() || !causes_lane_.result() || !(*causes_lane_.result_key() == picture_key()))
    return nullptr;
  return causes_lane_.result();
}

std::vector<std::uint32_t> Workbench::failed_pixels() const {
  const auto found = causes();
  if (!found) return judgement() ? judgement()->failed : std::vector<std::uint32_t>();
  std::vector<std::uint32_t> failed;
  for (std::uint32_t pixel = 0; pixel < found->pair_at.size(); ++pixel) {
    if (found->pair_at[pixel] != background_id) failed.push_back(pixel);
  }
  return failed;
}

bool Workbench::picture_is_current() const {
  return model_is_current() && picture() && picture_lane_.result_key() == picture_key();
}

std::shared_ptr<const Truth> Workbench::truth() const {
  if (!model_is_current() || !truth_lane_.result() || !(*truth_lane_.result_key() == view_key()))
    return nullptr;
  return truth_lane_.result();
}

std::shared_ptr<const Judgement> Workbench::judgement() const {
  if (!model_is_current() || !judgement_lane_.result() || !(*judgement_lane_.result_key() == picture_key()))
    return nullptr;
  return judgement_lane_.result();
}

State Workbench::exact_state() const {
  State exact = state;
  exact.picture = picture_size();
  if (model_is_current()) exact.camera = camera();
  return exact;
}

void Workbench::move_camera(const Camera& camera) {
  state.camera = camera;
  camera_moved_ = now_;
  settling_ = true;
}

void Workbench::open_scene(const std::string& words) {
  set_scene(state, words);
  model_lane_.retry();
}

void Workbench::select_algorithm(const AlgorithmSpec& spec) { set_algorithm(state, spec); }

void Workbench::move_corner(std::uint32_t corner, const glm::vec3& position) {
  const auto found = std::ranges::find(state.moved, corner, &MovedCorner::corner);
  if (found != state.moved.end()) {
    found->position = position;
  } else {
    state.moved.push_back({corner, position});
  }
}

}  // namespace hsr::window
