#include "window/results/rendered.h"

#include <algorithm>
#include <utility>

#include "picture.h"
#include "scene/errors.h"

namespace hsr::window {
namespace {

/// Enough to switch between all algorithms and back.
constexpr std::size_t most_prepared = 12;

}  // namespace

PreparedRenderers::Entry& PreparedRenderers::get(const Model& model, const PictureKey& key,
                                                 const RenderOptions& options) {
  // What was prepared for another scene is of no use any more.
  entries_.remove_if([&](const Entry& entry) { return entry.model != model.number; });
  const auto found = std::ranges::find_if(entries_, [&](const Entry& entry) {
    return entry.algorithm == key.algorithm && entry.skips_off == key.skips_off;
  });
  if (found != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, found);
    return entries_.front();
  }
  const AlgorithmSpec spec = parse_algorithm_spec(key.algorithm);
  const Stopwatch stopwatch;
  auto renderer = spec.algorithm->prepare(*model.scene, spec.settings, options);
  const double prepare_ms = stopwatch.milliseconds();
  if (!report_progress(options.progress, "preparing", 1.0)) throw InputError("stopped");
  entries_.push_front(
      {model.number, key.algorithm, key.skips_off, model.scene, std::move(renderer), prepare_ms});
  if (entries_.size() > most_prepared) entries_.pop_back();
  return entries_.front();
}

AlgorithmSpec spec_of(const PictureKey& key) {
  return key.elsewhere ? program_spec() : parse_algorithm_spec(key.algorithm);
}

View view_of(const Surroundings& given, const ViewKey& key) {
  return make_view(*given.model->scene, key.camera, key.size.width, key.size.height);
}

namespace {

/// Throws InputError unless the file's picture is one of this view.
void require_same_view(const ToldPicture& picture, const View& view) {
  const bool same_size = picture.frame.width == view.width && picture.frame.height == view.height;
  const bool same_view =
      !picture.view || *picture.view == ToldView{view.camera, view.near_depth, view.far_depth};
  if (!same_size || !same_view)
    throw InputError("the picture of the file is one of another view (R goes back to it)");
}

Rendered picture_from_elsewhere(const PictureKey& key, const Surroundings& given, const Progress& progress) {
  Rendered rendered;
  rendered.scene = given.model->scene;
  rendered.view = view_of(given, key.view);
  if (key.elsewhere->source.kind == Elsewhere::Kind::file) {
    rendered.told = given.told;
    require_same_view(given.told->picture, rendered.view);
  } else {
    rendered.told = std::make_shared<const FromElsewhere>(
        run_elsewhere(*key.elsewhere, *given.model, rendered.view, given.limits, progress));
    rendered.render_ms = 1000.0 * rendered.told->seconds;
  }
  rendered.frame = rendered.told->picture.frame;
  const Frame& frame = rendered.frame;
  rendered.screen = screen_picture(frame.color, frame.width, frame.height, given.backdrop);
  return rendered;
}

}  // namespace

Rendered render_picture(const PictureKey& key, const Surroundings& given, PreparedRenderers& prepared,
                        const Progress& progress) {
  if (key.elsewhere) return picture_from_elsewhere(key, given, progress);
  Rendered rendered;
  rendered.scene = given.model->scene;
  rendered.view = view_of(given, key.view);
  const RenderOptions options = {given.threads, key.skips_off, progress};
  PreparedRenderers::Entry& entry = prepared.get(*given.model, key, options);
  rendered.prepare_ms = entry.prepare_ms;
  rendered.frame = Frame(key.view.size.width, key.view.size.height);
  const Stopwatch stopwatch;
  rendered.report = entry.renderer->render(rendered.view, options, rendered.frame);
  rendered.render_ms = stopwatch.milliseconds();
  const Frame& frame = rendered.frame;
  rendered.screen = screen_picture(frame.color, frame.width, frame.height, given.backdrop);
  return rendered;
}

}  // namespace hsr::window
