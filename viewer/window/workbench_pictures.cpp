// Which picture the workbench shows: camera, size, and who makes it.

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <utility>

#include "window/theme.h"
#include "window/variants.h"
#include "window/workbench.h"

namespace hsr::window {
namespace {

/// What a picture may take while the camera moves, and how many times coarser it may be for that.
constexpr double moving_ms = 40.0;
constexpr int coarsest = 6;

/// The algorithm that makes the same picture sooner, if there is one: for while the camera moves.
std::string quick_variant(const AlgorithmSpec& spec, const std::string& own) {
  const Algorithm* fast = fast_version_of(*spec.algorithm);
  return fast != nullptr && own == spec.algorithm->name ? std::string(fast->name) : own;
}

ViewKey coarser(ViewKey key, int times) {
  key.size.width = std::max(1, key.size.width / times);
  key.size.height = std::max(1, key.size.height / times);
  return key;
}

}  // namespace

Extent Workbench::picture_size() const {
  if (const auto told = file()) return {told->picture.frame.width, told->picture.frame.height};
  return state.picture.value_or(panel_);
}

Camera Workbench::camera() const {
  const auto told = file();
  if (!state.camera && told && told->picture.view) return told->picture.view->camera;
  return state.camera.value_or(home_camera_);
}

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

PictureKey Workbench::picture_key() const {
  if (!shows_elsewhere()) return {view_key(), state.algorithm.text(), state.skips_off, std::nullopt};
  return {view_key(), maker_name(), {}, ElsewhereKey{*state.elsewhere, runs_}};
}

std::string Workbench::maker_name() const {
  return shows_elsewhere() ? program_spec().text() : state.algorithm.text();
}

std::string Workbench::other_name() const { return state.other ? state.other->text() : "exact answer"; }

Surroundings Workbench::surroundings() const {
  return {model(), threads_, limits, palette_of(state.theme).backdrop,
          picture_is_current() ? picture()->told : nullptr};
}

int Workbench::coarseness() const {
  if (shows_file() || !settling_ || full_ms_ <= moving_ms) return 1;
  return std::min(coarsest, static_cast<int>(std::ceil(std::sqrt(full_ms_ / moving_ms))));
}

std::shared_ptr<const FromElsewhere> Workbench::file() const {
  if (!shows_elsewhere() || !model() || !file_lane_.result_key()) return nullptr;
  const FileKey& key = *file_lane_.result_key();
  const bool same = key.elsewhere.source == *state.elsewhere && key.model == model()->number;
  return same ? file_lane_.result() : nullptr;
}

std::optional<std::string> Workbench::watched_file() const {
  if (shows_file()) return state.elsewhere->words;
  if (watched && shows_elsewhere()) return watched->string();
  return std::nullopt;
}

void Workbench::watch_file() {
  const std::optional<std::string> file = watched_file();
  if (!file) return watch_.stop();
  if (watch_.changed(*file)) run_again();
}

void Workbench::show_from(const Elsewhere& elsewhere) {
  state.elsewhere = elsewhere;
  state.show_elsewhere = true;
  if (elsewhere.kind == Elsewhere::Kind::file) state.camera.reset();
}

void Workbench::run_again() { ++runs_; }

std::string Workbench::elsewhere_problem() const {
  if (!shows_elsewhere() || picture_is_current()) return {};
  return file_lane_.error().empty() ? picture_lane_.error() : file_lane_.error();
}

void Workbench::want_pictures() {
  if (shows_elsewhere()) {
    if (state.elsewhere->kind == Elsewhere::Kind::command && !state.elsewhere->allowed) return;
    if (shows_file()) {
      file_lane_.want({{*state.elsewhere, runs_}, model()->number}, true, [&] {
        return [key = ElsewhereKey{*state.elsewhere, runs_}, scene = model()](const Progress&) {
          return read_elsewhere(key, *scene);
        };
      });
      if (!file() || file_lane_.result_key()->elsewhere.run != runs_) return;
    }
  }
  PictureKey key = picture_key();
  key.view = coarser(key.view, coarseness());
  if (coarseness() > 1) key.algorithm = quick_variant(state.algorithm, key.algorithm);
  const auto make = [this](const PictureKey& wanted, const std::shared_ptr<PreparedRenderers>& prepared) {
    Surroundings given = surroundings();
    given.told = file();
    return [wanted, prepared, given](const Progress& progress) {
      return render_picture(wanted, given, *prepared, progress);
    };
  };
  // A picture on its way is finished while the camera moves, or there would be none before it rests.
  picture_lane_.want(key, !settling_, [&] { return make(key, prepared_); });
  if (state.comparing == Comparing::off || !state.other) return;
  PictureKey other_key = key;
  other_key.algorithm = state.other->text();
  other_key.elsewhere.reset();
  other_key.skips_off.clear();
  other_lane_.want(other_key, !settling_, [&] { return make(other_key, other_prepared_); });
}

}  // namespace hsr::window
