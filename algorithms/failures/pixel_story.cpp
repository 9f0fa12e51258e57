#include "failures/pixel_story.h"

#include <algorithm>
#include <array>
#include <unordered_set>

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

// Runs the algorithm at the pixel alone; what is kept of steps about no pixel is up to `among`.
// Adds every triangle that a step at the pixel is about to `seen`.
void run_once(const View& view, Renderer& renderer, RenderOptions options, const EventFilter& filter,
              std::unordered_set<std::uint32_t>& seen, PixelStory& story) {
  options.window = filter.window;
  DepartureFinder finder([&story](int, int, std::uint32_t id) { return story.admissible(id); });
  Frame frame(view.width, view.height);
  const TracedRun run = [&](const EventListener& listener) {
    std::uint64_t wanted = 0;
    renderer.trace(
        view, options,
        [&](const Event& event) {
          if (event.i >= 0 && event.p != background_id) seen.insert(event.p);
          const bool is_wanted = filter.wants(event);
          if (is_wanted) ++wanted;
          finder.tell(event, is_wanted ? wanted : 0);
          listener(event);
        },
        frame);
  };
  story.history = record(run, filter);
  story.departure = finder.first();
  const std::size_t pixel = frame.index(story.i, story.j);
  story.id = frame.id[pixel];
  story.depth = frame.depth[pixel];
  story.color = frame.color[pixel];
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

  // Nearly always the triangles at the pixel are those of the exact list.
  std::unordered_set<std::uint32_t> seen;
  for (const exact::Fragment& fragment : story.list) seen.insert(fragment.id);
  EventFilter filter = {.window = PixelBox{i, i, j, j}};
  std::size_t known = 0;
  do {
    known = seen.size();
    filter.among = IdSet({seen.begin(), seen.end()});
    run_once(view, renderer, options, filter, seen, story);
  } while (seen.size() > known);
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
