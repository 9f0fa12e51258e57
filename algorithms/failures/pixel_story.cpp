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
void record_history(const TracedRun& run, const EventFilter& filter, PixelStory& story) {
  DepartureFinder finder([&story](int, int, std::uint32_t id) { return story.admissible(id); });
  const TracedRun watched = [&](const EventListener& listener) {
    std::uint64_t step = 0;
    run([&](const Event& event) {
      const bool wanted = filter.wants(event);
      if (wanted) ++step;
      finder.tell(event, wanted ? step : 0);
      listener(event);
    });
  };
  story.history = record(watched, filter);
  story.departure = finder.first();
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

PixelStory tell_pixel(const View& view, Renderer& renderer, const RenderOptions& options, int i, int j) {
  PixelStory story;
  story.i = i;
  story.j = j;
  story.list = exact::depth_list(view, i, j);
  story.exact_color = color_of_list(*view.scene, story.list);

  Frame frame;
  RenderOptions pixel_options = options;
  pixel_options.window = PixelBox{i, i, j, j};
  const TracedRun run = kept([&](const EventListener& listener) {
    frame = Frame(view.width, view.height);
    renderer.trace(view, pixel_options, listener, frame);
  });
  EventFilter filter = {.window = pixel_options.window};
  filter.among = triangles_at(run, *filter.window, *view.scene);
  record_history(run, filter, story);
  const std::size_t pixel = frame.index(i, j);
  story.id = frame.id[pixel];
  story.depth = frame.depth[pixel];
  story.color = frame.color[pixel];
  return story;
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
