#include "window/results/steps.h"

#include <algorithm>
#include <mutex>

#include "exact/worker.h"
#include "failures/first_departure.h"
#include "picture.h"
#include "scene/errors.h"
#include "trace/sentences.h"
#include "trace_animation.h"
#include "view/shading.h"
#include "window/variants.h"

namespace hsr::window {
namespace {

/// A renderer that several threads may use, one after the other.
struct SharedRenderer {
  std::mutex mutex;
  std::unique_ptr<Renderer> renderer;
};

constexpr std::size_t most_marks = 200000;

std::vector<std::uint32_t> triangles_of_face(const Scene& scene, std::uint32_t face) {
  std::vector<std::uint32_t> ids;
  for (std::uint32_t id = 0; id < scene.triangles.size(); ++id) {
    if (scene.triangles[id].face == face) ids.push_back(id);
  }
  return ids;
}

void mark(std::vector<std::uint64_t>& marks, std::uint64_t step) {
  if (marks.size() < most_marks) marks.push_back(step);
}

bool is_turn(EventKind kind) {
  return kind == EventKind::exchanged || kind == EventKind::cycled || kind == EventKind::crossed ||
         kind == EventKind::split;
}

/// The same run, which throws InputError when the progress function asks to stop.
TracedRun stoppable(const TracedRun& run, const Progress& progress, std::string_view stage) {
  return [run, progress, stage](const EventListener& listener) {
    constexpr std::uint64_t often = 1U << 16U;
    std::uint64_t number = 0;
    run([&](const Event& event) {
      if (++number % often == 0 && !report_progress(progress, stage, 0.5)) throw InputError("stopped");
      listener(event);
    });
  };
}

bool visits(EventKind kind) {
  return kind == EventKind::node_entered || kind == EventKind::node_passed_by ||
         kind == EventKind::cell_entered;
}

/// What the ray of the last step came to since it started.
std::vector<Event> visited_nodes(const Player& player) {
  constexpr std::size_t farthest_back = 5000;
  std::vector<Event> visited;
  const Event* last = player.last();
  if (last == nullptr || last->i < 0) return visited;
  for (std::size_t back = 0; back < farthest_back; ++back) {
    const Event* event = player.earlier(back);
    if (event == nullptr || event->i != last->i || event->j != last->j) break;
    if (visits(event->kind)) visited.push_back(*event);
    if (event->kind == EventKind::ray_started) break;
  }
  std::ranges::reverse(visited);
  return visited;
}

/// Some places before and after that of the step's triangle; while places are given, those given so far.
std::vector<Event> order_about(const Event& event, const std::vector<Event>& order) {
  constexpr std::size_t before = 5;
  constexpr std::size_t after = 4;
  const auto found = std::ranges::find(order, event.p, &Event::p);
  if (found == order.end()) return {};
  const auto place = static_cast<std::size_t>(found - order.begin());
  const std::size_t first = place - std::min(place, before);
  const std::size_t last =
      event.kind == EventKind::placed ? place + 1 : std::min(order.size(), place + 1 + after);
  return {order.begin() + static_cast<std::ptrdiff_t>(first),
          order.begin() + static_cast<std::ptrdiff_t>(last)};
}

}  // namespace

Trace make_trace(const TraceKey& key, const Surroundings& given, const Progress& progress) {
  Trace trace;
  trace.scene = given.model->scene;
  trace.view = view_of(given, key.picture.view);
  RenderOptions options = {1, key.picture.skips_off, progress};
  const AlgorithmSpec spec = telling_version(spec_of(key.picture));
  const auto shared = std::make_shared<SharedRenderer>();
  shared->renderer =
      given.told ? told_renderer(given.told) : spec.algorithm->prepare(*trace.scene, spec.settings, options);
  if (key.of == StepsOf::pixel) options.window = PixelBox{key.pixel.x, key.pixel.x, key.pixel.y, key.pixel.y};
  options.progress = {};  // a later run must not be stopped by what stops this one
  const TracedRun all = [shared, scene = trace.scene, view = trace.view,
                         options](const EventListener& listener) {
    const std::lock_guard lock(shared->mutex);
    Frame frame(view.width, view.height);
    shared->renderer->trace(view, options, listener, frame);
  };
  EventFilter filter;
  filter.window = options.window;
  if (filter.window)
    filter.among = triangles_at(stoppable(all, progress, "finding triangles"), *filter.window, *trace.scene);
  if (key.of == StepsOf::face) filter.about = IdSet(triangles_of_face(*trace.scene, key.face));
  trace.run = [all, filter](const EventListener& listener) {
    all([&](const Event& event) {
      if (filter.wants(event)) listener(event);
    });
  };
  if (!report_progress(progress, "counting steps", 0.3)) throw InputError("stopped");
  trace.player_progress = std::make_shared<Progress>(progress);
  const TracedRun players_run = [run = trace.run,
                                 asked = trace.player_progress](const EventListener& listener) {
    stoppable(run, *asked, "counting steps")(listener);
  };
  trace.player = std::make_shared<Player>(trace.view.width, trace.view.height,
                                          surface_colors(*trace.scene, given.threads), players_run);
  *trace.player_progress = {};
  trace.total = trace.player->total();
  stoppable(trace.run, progress, "reading the order")([&trace](const Event& event) {
    if (event.kind == EventKind::placed && trace.order.size() < most_marks) trace.order.push_back(event);
  });
  return trace;
}

Moment find_moment(const MomentKey& key, const Trace& trace, const glm::vec3& backdrop,
                   const Progress& progress) {
  const Stopwatch stopwatch;
  Player& player = *trace.player;
  *trace.player_progress = progress;
  player.go_to(std::min(key.step, trace.total));
  Moment moment;
  moment.step = player.step();
  *trace.player_progress = {};
  const Frame& frame = player.picture();
  moment.screen = screen_picture(frame.color, frame.width, frame.height, backdrop);
  if (const Event* last = player.last()) {
    moment.event = *last;
    moment.sentence = sentence(*last);
  }
  glm::ivec2 pixel = key.pixel;
  if (moment.event && moment.event->i >= 0) pixel = {moment.event->i, moment.event->j};
  const bool in_picture = pixel.x >= 0 && pixel.x < trace.view.width && pixel.y < trace.view.height;
  if (in_picture) moment.list = player.state().list(pixel.x, pixel.y);
  moment.visited = visited_nodes(player);
  if (moment.event) moment.order = order_about(*moment.event, trace.order);
  moment.milliseconds = stopwatch.milliseconds();
  return moment;
}

void write_gif_of(const Trace& trace, const std::filesystem::path& file, const Surroundings& given,
                  const Progress& progress) {
  write_animation(trace.view, stoppable(trace.run, progress, "writing"), {{}, 1, trace.total}, given.backdrop,
                  given.threads, file);
}

Marks find_marks(const MarksKey& key, const Trace& trace, const std::shared_ptr<const Truth>& truth,
                 const Progress& progress) {
  Marks marks;
  std::unique_ptr<exact::Worker> worker;
  if (truth) worker = std::make_unique<exact::Worker>(truth->answer->worker());
  DepartureFinder finder([&](int i, int j, std::uint32_t id) {
    const std::uint32_t nearest = truth->nearest.id[truth->frame.index(i, j)];
    if (id == nearest || nearest == background_id) return id == nearest;
    return worker->covers(id, i, j) && worker->compare_depth(id, nearest, i, j) == 0;
  });
  std::uint64_t step = 0;
  stoppable(trace.run, progress, "marking steps")([&](const Event& event) {
    ++step;
    if (truth) finder.tell(event, step);
    if (event.i >= 0 && event.i == key.pixel.x && event.j == key.pixel.y) mark(marks.pixel, step);
    if (event.p < trace.scene->triangles.size() && trace.scene->triangles[event.p].face == key.face) {
      mark(marks.face, step);
    }
    if (is_turn(event.kind)) mark(marks.turns, step);
  });
  if (truth) {
    if (const auto departure = finder.first()) marks.departure = departure->step;
  }
  return marks;
}

}  // namespace hsr::window
