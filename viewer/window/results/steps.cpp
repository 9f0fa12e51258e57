#include "window/results/steps.h"

#include <mutex>

#include "exact/worker.h"
#include "failures/first_departure.h"
#include "scene/errors.h"
#include "trace/sentences.h"
#include "view/shading.h"

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

}  // namespace

Trace make_trace(const TraceKey& key, const Surroundings& given, const Progress& progress) {
  Trace trace;
  trace.scene = given.model->scene;
  trace.view = view_of(given, key.picture.view);
  RenderOptions options = {1, key.picture.skips_off, progress};
  const AlgorithmSpec spec = spec_of(key.picture);
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
  if (filter.window) filter.among = triangles_at(all, *filter.window, *trace.scene);
  if (key.of == StepsOf::face) filter.about = IdSet(triangles_of_face(*trace.scene, key.face));
  trace.run = [all, filter](const EventListener& listener) {
    all([&](const Event& event) {
      if (filter.wants(event)) listener(event);
    });
  };
  if (!report_progress(progress, "counting steps", 0.3)) throw InputError("stopped");
  trace.player = std::make_shared<Player>(trace.view.width, trace.view.height,
                                          surface_colors(*trace.scene, given.threads), trace.run);
  trace.total = trace.player->total();
  return trace;
}

Moment find_moment(const MomentKey& key, const Trace& trace) {
  Player& player = *trace.player;
  player.go_to(std::min(key.step, trace.total));
  Moment moment;
  moment.step = player.step();
  moment.frame = player.picture();
  if (const Event* last = player.last()) {
    moment.event = *last;
    moment.sentence = sentence(*last);
  }
  const bool in_picture =
      key.pixel.x >= 0 && key.pixel.x < trace.view.width && key.pixel.y < trace.view.height;
  if (in_picture) moment.list = player.state().list(key.pixel.x, key.pixel.y);
  return moment;
}

Marks find_marks(const MarksKey& key, const Trace& trace, const std::shared_ptr<const Truth>& truth) {
  Marks marks;
  std::unique_ptr<exact::Worker> worker;
  if (truth) worker = std::make_unique<exact::Worker>(truth->answer->worker());
  DepartureFinder finder([&](int i, int j, std::uint32_t id) {
    const std::uint32_t nearest = truth->nearest.id[truth->frame.index(i, j)];
    if (id == nearest || nearest == background_id) return id == nearest;
    return worker->covers(id, i, j) && worker->compare_depth(id, nearest, i, j) == 0;
  });
  std::uint64_t step = 0;
  trace.run([&](const Event& event) {
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
