#include "failures/pixel_story.h"

#include <algorithm>
#include <array>
#include <memory>

#include "exact/depth_list.h"
#include "predicates/sample_predicates.h"
#include "view/screen_triangles.h"
#include "view/shading.h"

namespace hsr {

namespace {

glm::vec4 color_of_list(const Scene& scene, const std::vector<exact::Fragment>& list) {
  glm::vec4 color(0.0F);
  for (const exact::Fragment& fragment : list) {
    if (!fragment.tied) color = over(color, surface_color(scene, fragment.id));
  }
  return color;
}

/// The same run without making it again: its steps are kept, up to a bound on memory.
TracedRun kept(const TracedRun& run) {
  constexpr std::size_t most = 1'000'000;  // 72 MB
  const auto steps = std::make_shared<std::vector<Event>>();
  bool all = true;
  run([&](const Event& event) {
    all = all && steps->size() < most;
    if (all) steps->push_back(event);
  });
  if (!all) return run;
  return [steps](const EventListener& listener) {
    for (const Event& event : *steps) listener(event);
  };
}

/// Gathers the history and the departure, with each step that the filter wants counted once.
void record_history(const std::vector<Event>& steps, const EventFilter& filter, PixelStory& story) {
  DepartureFinder finder([&story](int, int, std::uint32_t id) { return story.admissible(id); });
  const TracedRun watched = [&](const EventListener& listener) {
    std::uint64_t step = 0;
    for (const Event& event : steps) {
      if (!filter.wants(event)) continue;
      finder.tell(event, ++step);
      listener(event);
    }
  };
  story.history = record(watched, filter);
  story.departure = finder.first();
}

bool same(const PixelBox& a, const PixelBox& b) {
  return a.first_i == b.first_i && a.last_i == b.last_i && a.first_j == b.first_j && a.last_j == b.last_j;
}

}  // namespace

bool PixelStory::admissible(std::uint32_t shown) const {
  for (const exact::Fragment& fragment : list) {
    const bool nearest = &fragment == list.data() || fragment.tied;
    if (!nearest) return false;
    if (fragment.id == shown) return true;
  }
  return false;
}

const exact::Fragment* PixelStory::fragment_of(std::uint32_t shown) const {
  const auto found = std::ranges::find(list, shown, &exact::Fragment::id);
  return found == list.end() ? nullptr : &*found;
}

PixelTeller::PixelTeller(const View& view, Renderer& renderer, const RenderOptions& options, int side)
    : view_(view), renderer_(renderer), options_(options), side_(side) {
  options_.progress = {};
}

void PixelTeller::trace_square(const PixelBox& square, const Progress& progress) {
  square_.reset();
  RenderOptions options = options_;
  options.window = square;
  options.progress = progress;
  const TracedRun run = kept([&](const EventListener& listener) {
    frame_ = Frame(view_.width, view_.height);
    renderer_.trace(view_, options, listener, frame_);
  });
  // What is about a triangle that occurs at one of the pixels, whatever the other triangle: more than any one
  // of them will want.
  const IdSet here = triangles_at(run, square, *view_.scene);
  const EventFilter at_pixels = {.window = square};
  steps_.clear();
  run([&](const Event& event) {
    const bool wanted = event.p == background_id || here.contains(event.p);
    if (event.i < 0 ? wanted : at_pixels.wants(event)) steps_.push_back(event);
  });
  if (report_progress(progress, "looking into the pixel", 0.5)) square_ = square;
}

PixelStory PixelTeller::tell(int i, int j, const Progress& progress) {
  PixelStory story;
  story.i = i;
  story.j = j;
  story.list = exact::depth_list(view_, i, j);
  story.exact_color = color_of_list(*view_.scene, story.list);
  const int left = i / side_ * side_;
  const int top = j / side_ * side_;
  const PixelBox square = {left, std::min(left + side_, view_.width) - 1, top,
                           std::min(top + side_, view_.height) - 1};
  if (!square_ || !same(*square_, square)) trace_square(square, progress);
  EventFilter filter = {.window = PixelBox{i, i, j, j}};
  const TracedRun steps = [this](const EventListener& listener) {
    for (const Event& event : steps_) listener(event);
  };
  filter.among = triangles_at(steps, *filter.window, *view_.scene);
  record_history(steps_, filter, story);
  const std::size_t pixel = frame_.index(i, j);
  story.id = frame_.id[pixel];
  story.depth = frame_.depth[pixel];
  story.color = frame_.color[pixel];
  return story;
}

PixelStory tell_pixel(const View& view, Renderer& renderer, const RenderOptions& options, int i, int j) {
  return PixelTeller(view, renderer, options, 1).tell(i, j, options.progress);
}

std::vector<bool> fronts(const View& view, const std::vector<exact::Fragment>& list) {
  const Scene& scene = *view.scene;
  const Projection projection = projection_of(view);
  SamplePredicates predicates(projection, scene);
  std::vector<bool> fronts;
  fronts.reserve(list.size());
  for (const exact::Fragment& fragment : list) {
    std::array<Homogeneous<Bounded>, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] =
          clip_from_world<Bounded>(projection, scene.positions[scene.triangles[fragment.id].corners[k]]);
    }
    const auto triangle = predicates.set_up(fragment.id, corner);
    fronts.push_back(triangle && triangle->front);
  }
  return fronts;
}

}  // namespace hsr
