#include "window/results/story.h"

#include <algorithm>
#include <unordered_map>

#include "picture.h"
#include "pixel_text.h"
#include "scene/errors.h"
#include "trace/sentences.h"
#include "view/shading.h"
#include "window/variants.h"

namespace hsr::window {
namespace {

constexpr std::size_t most_history = 400;

bool decides(EventKind kind) {
  return kind == EventKind::depth_tested || kind == EventKind::triangle_tested || kind == EventKind::compared;
}

bool meets_fragment(EventKind kind) {
  return kind == EventKind::painted || kind == EventKind::depth_tested ||
         kind == EventKind::fragment_stored || kind == EventKind::fragment_dropped ||
         kind == EventKind::triangle_tested;
}

void find_own_order(Story& story) {
  std::unordered_map<std::uint32_t, std::uint32_t> place;
  for (std::uint32_t k = 0; k < story.pixel.list.size(); ++k) place[story.pixel.list[k].id] = k;
  std::vector<bool> met(story.pixel.list.size(), false);
  for (const Event& event : story.pixel.history.events) {
    if (event.i < 0 || !meets_fragment(event.kind)) continue;
    const auto found = place.find(event.p);
    if (found == place.end() || met[found->second]) continue;
    met[found->second] = true;
    story.own_order.push_back(found->second);
    story.painted |= event.kind == EventKind::painted;
  }
}

/// The order of the list that was told in place of steps.
void find_told_order(Story& story, const Frame& frame) {
  if (!frame.lists) return;
  const std::size_t pixel = frame.index(story.pixel.i, story.pixel.j);
  for (std::size_t k = frame.lists->begin[pixel]; k < frame.lists->begin[pixel + 1]; ++k) {
    const auto found =
        std::ranges::find(story.pixel.list, frame.lists->fragments[k].id, &exact::Fragment::id);
    if (found != story.pixel.list.end())
      story.own_order.push_back(static_cast<std::uint32_t>(found - story.pixel.list.begin()));
  }
}

/// Why the pixel has its colour, as far as that is known of a program that tells no steps.
std::string explain_silent(const PixelStory& pixel) {
  const std::string shown = pixel.id == background_id ? "nothing" : "triangle " + std::to_string(pixel.id);
  if (!pixel.covered() && pixel.id == background_id) return "Right: nothing covers the pixel's centre.";
  if (!pixel.covered()) return "Wrong: " + shown + " is shown, although nothing covers the pixel's centre.";
  if (pixel.admissible(pixel.id)) return "Right: " + shown + " is shown, the nearest here.";
  const exact::Fragment& nearest = pixel.list.front();
  return "Wrong: " + shown + " is shown, although triangle " + std::to_string(nearest.id) +
         " lies here at depth " + tell_apart(nearest.depth, nearest.depth).value +
         "; the program tells no steps, so why is not known.";
}

void accumulate(Story& story) {
  glm::vec4 seen(0.0F);
  for (const exact::Fragment& fragment : story.pixel.list) {
    const glm::vec4 color = surface_color(*story.view.scene, fragment.id);
    story.colors.push_back(color);
    if (!fragment.tied) seen = over(seen, color);  // of equally near ones the first counts
    story.so_far.push_back(seen);
  }
}

void write_history(Story& story) {
  const Recording& history = story.pixel.history;
  story.history_total = history.total;
  for (std::size_t k = 0; k < std::min(history.events.size(), most_history); ++k) {
    const Event& event = history.events[k];
    const bool departs = story.pixel.departure && story.pixel.departure->step == history.first + k;
    story.history.push_back({sentence(event), decides(event.kind), event.passed, departs});
  }
}

/// Pixels whose steps are kept together.
constexpr int square_side = 16;

/// Without a progress function: what is prepared or traced may be kept for longer than it is asked.
RenderOptions options_for(const PictureKey& key, const Surroundings& given) {
  return {given.threads, key.skips_off, {}};
}

}  // namespace

void StoryKeeper::prepare(const PictureKey& picture, const Surroundings& given, const Progress& progress) {
  if (picture_ == picture) return;
  teller_.reset();  // it holds a renderer that may have to go
  picture_.reset();
  RenderOptions options = options_for(picture, given);
  options.progress = progress;
  PictureKey telling = picture;
  telling.algorithm = telling_version(spec_of(picture)).text();
  Renderer& renderer = *prepared_.get(*given.model, telling, options).renderer;
  teller_ = std::make_unique<PixelTeller>(view_of(given, picture.view), renderer, options_for(picture, given),
                                          square_side);
  picture_ = picture;
}

PixelStory StoryKeeper::tell(const StoryKey& key, std::uint32_t shown, const Surroundings& given,
                             const Progress& progress) {
  prepare(key.picture, given, progress);
  PixelStory story = teller_->tell(key.pixel.x, key.pixel.y, progress);
  if (!report_progress(progress, "looking into the pixel", 1.0)) throw InputError("stopped");
  const AlgorithmSpec spec = spec_of(key.picture);
  if (story.id == shown || spec.algorithm->variant_of.empty()) return story;
  // A fast version whose settings make another picture (floats at their word) speaks for itself.
  RenderOptions options = options_for(key.picture, given);
  options.progress = progress;
  return tell_pixel(view_of(given, key.picture.view),
                    *prepared_.get(*given.model, key.picture, options).renderer, options, key.pixel.x,
                    key.pixel.y);
}

Story tell_story(const StoryKey& key, std::uint32_t shown, const Surroundings& given, StoryKeeper& keeper,
                 const Progress& progress) {
  const Stopwatch stopwatch;
  Story story;
  story.scene = given.model->scene;
  story.view = view_of(given, key.picture.view);
  if (!given.told) keeper.prepare(key.picture, given, progress);
  if (key.pixel.x < 0) return story;  // all is prepared
  if (given.told) {
    const RenderOptions options = {given.threads, key.picture.skips_off, progress};
    story.pixel = tell_pixel(story.view, *told_renderer(given.told), options, key.pixel.x, key.pixel.y);
  } else {
    story.pixel = keeper.tell(key, shown, given, progress);
  }
  if (!report_progress(progress, "looking into the pixel", 1.0)) throw InputError("stopped");
  const AlgorithmSpec spec = spec_of(key.picture);
  const bool silent = given.told && !given.told->picture.tells_steps;
  story.explanation = silent ? explain_silent(story.pixel) : explanation(story.view, spec, story.pixel);
  story.fronts = fronts(story.view, story.pixel.list);
  accumulate(story);
  if (silent) {
    find_told_order(story, given.told->picture.frame);
  } else {
    find_own_order(story);
  }
  write_history(story);
  story.text = to_text(story.pixel, story.view, spec);
  story.milliseconds = stopwatch.milliseconds();
  return story;
}

}  // namespace hsr::window
