#include "window/workbench.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <utility>

namespace hsr::window {
namespace {

/// How long the camera must rest before a picture in full size is begun.
constexpr double rest_seconds = 0.15;
/// What a picture may take while the camera moves, and how many times coarser it may be for that.
constexpr double moving_ms = 40.0;
constexpr int coarsest = 6;

ViewKey coarser(ViewKey key, int times) {
  key.size.width = std::max(1, key.size.width / times);
  key.size.height = std::max(1, key.size.height / times);
  return key;
}

}  // namespace

Workbench::Workbench(std::function<void()> wake, int threads)
    : threads_(threads),
      model_lane_(wake),
      picture_lane_(wake),
      other_lane_(wake),
      truth_lane_(wake),
      judgement_lane_(wake),
      causes_lane_(wake),
      story_lane_(wake),
      trace_lane_(wake),
      moment_lane_(wake),
      marks_lane_(wake),
      lengths_lane_(wake) {}

template <class Self, class Visit>
void Workbench::for_each_lane(Self& self, Visit visit) {
  visit("scene", self.model_lane_);
  visit("picture", self.picture_lane_);
  visit("other picture", self.other_lane_);
  visit("exact answer", self.truth_lane_);
  visit("comparison", self.judgement_lane_);
  visit("causes", self.causes_lane_);
  visit("pixel", self.story_lane_);
  visit("steps", self.trace_lane_);
  visit("step", self.moment_lane_);
  visit("marks", self.marks_lane_);
  visit("lists", self.lengths_lane_);
}

Extent Workbench::picture_size() const { return state.picture.value_or(panel_); }

Camera Workbench::camera() const { return state.camera.value_or(home_camera_); }

void Workbench::find_home_camera() {
  const Scene& scene = *model()->scene;
  const double aspect = static_cast<double>(picture_size().width) / picture_size().height;
  if (home_of_ == std::pair(model()->number, aspect)) return;
  home_of_ = {model()->number, aspect};
  home_camera_ = scene.camera ? *scene.camera : framing_camera(scene, aspect);
  // The scenes' own cameras are meant for pictures at least this wide; a narrower one must not cut off more.
  constexpr double narrowest = 16.0 / 9.0;
  if (scene.camera && aspect < narrowest) {
    const double half = glm::radians(home_camera_.vertical_fov_degrees) / 2.0;
    home_camera_.vertical_fov_degrees = glm::degrees(2.0 * std::atan(std::tan(half) * narrowest / aspect));
  }
}

ViewKey Workbench::view_key() const { return {model()->number, camera(), picture_size()}; }

PictureKey Workbench::picture_key() const { return {view_key(), state.algorithm.text(), state.skips_off}; }

std::string Workbench::other_name() const { return state.other ? state.other->text() : "exact answer"; }

Surroundings Workbench::surroundings() const { return {model(), threads_}; }

void Workbench::update(double seconds, Extent panel) {
  now_ = seconds;
  if (panel.width > 0 && panel.height > 0) fit_panel(panel);
  if (model_lane_.poll() && model_lane_.result_key()->moved.empty()) {
    unmoved_ = model()->scene;
    unmoved_name_ = model_lane_.result_key()->scene;
  }
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
  settling_ = now_ - camera_moved_ < rest_seconds;
  want_model();
  if (!model()) return;
  find_home_camera();
  if (!model_is_current()) return;
  want_pictures();
  want_truth();
  want_steps();
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

int Workbench::coarseness() const {
  if (!settling_ || full_ms_ <= moving_ms) return 1;
  return std::min(coarsest, static_cast<int>(std::ceil(std::sqrt(full_ms_ / moving_ms))));
}

void Workbench::want_pictures() {
  PictureKey key = picture_key();
  key.view = coarser(key.view, coarseness());
  const auto make = [this](const PictureKey& wanted, const std::shared_ptr<PreparedRenderers>& prepared) {
    return [wanted, prepared, given = surroundings()](const Progress& progress) {
      return render_picture(wanted, given, *prepared, progress);
    };
  };
  // A picture on its way is finished while the camera moves, or there would be none before it rests.
  picture_lane_.want(key, !settling_, [&] { return make(key, prepared_); });
  if (state.comparing == Comparing::off || !state.other) return;
  PictureKey other_key = key;
  other_key.algorithm = state.other->text();
  other_key.skips_off.clear();
  other_lane_.want(other_key, !settling_, [&] { return make(other_key, other_prepared_); });
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
  const bool colors_wrong = found->errors.color && found->errors.color->max > 0.0;
  if (found->failed.empty() && !colors_wrong) return;
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
  state.scene = words;
  state.moved.clear();
  state.camera.reset();
  state.pixel.reset();
  state.magnification = 1.0F;
  state.centre = glm::vec2(0.5F);
  model_lane_.retry();
}

void Workbench::select_algorithm(const AlgorithmSpec& spec) {
  state.algorithm = spec;
  state.skips_off.clear();
}

void Workbench::move_corner(std::uint32_t corner, const glm::vec3& position) {
  const auto found = std::ranges::find(state.moved, corner, &MovedCorner::corner);
  if (found != state.moved.end()) {
    found->position = position;
  } else {
    state.moved.push_back({corner, position});
  }
}

bool Workbench::busy() const {
  bool any = settling_;
  for_each_lane(*this, [&any](const char*, const auto& lane) { any |= lane.busy(); });
  return any;
}

void Workbench::cancel() {
  for_each_lane(*this, [](const char*, auto& lane) { lane.give_up(); });
}

bool Workbench::cancelled() const {
  bool any = false;
  for_each_lane(*this, [&any](const char*, const auto& lane) { any |= lane.has_given_up(); });
  return any;
}

void Workbench::retry() {
  for_each_lane(*this, [](const char*, auto& lane) { lane.retry(); });
}

std::vector<Workbench::Running> Workbench::running() const {
  std::vector<Running> pieces;
  for_each_lane(*this, [&pieces](const char* what, const auto& lane) {
    if (!lane.busy()) return;
    const auto [stage, done] = lane.progress();
    pieces.push_back({what, stage, done, lane.running_ms()});
  });
  return pieces;
}

std::vector<std::string> Workbench::problems() const {
  std::vector<std::string> lines;
  for_each_lane(*this, [&lines](const char*, const auto& lane) {
    const std::string& error = lane.error();
    if (!error.empty() && std::ranges::find(lines, error) == lines.end()) lines.push_back(error);
  });
  return lines;
}

}  // namespace hsr::window
