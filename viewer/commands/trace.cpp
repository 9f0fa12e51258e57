#include <algorithm>
#include <memory>
#include <ostream>

#include "commands/commands.h"
#include "exact/depth_list.h"
#include "exact/worker.h"
#include "failures/first_departure.h"
#include "output_file.h"
#include "picture.h"
#include "scene/atomic_file.h"
#include "scene/errors.h"
#include "skip_choice.h"
#include "step_text.h"
#include "text_layout.h"
#include "trace/event_json.h"
#include "trace/recording.h"
#include "trace_animation.h"

namespace hsr {
namespace {

// Without --to no more are told: the first and the last.
constexpr std::size_t told_first = 60;
constexpr std::size_t told_last = 20;
// With --to no more than this.
constexpr std::size_t most_told = 100'000;

/// The triangles of a face. Throws UsageError if there is no such face.
IdSet triangles_of_face(const Scene& scene, std::uint32_t face) {
  std::vector<std::uint32_t> ids;
  std::uint32_t greatest = 0;
  for (std::uint32_t id = 0; id < scene.triangles.size(); ++id) {
    greatest = std::max(greatest, scene.triangles[id].face);
    if (scene.triangles[id].face == face) ids.push_back(id);
  }
  if (ids.empty()) {
    throw UsageError("--face: there is no face " + std::to_string(face) +
                     (scene.triangles.empty() ? std::string("; the scene has none")
                                              : "; the scene has faces 0 to " + std::to_string(greatest)));
  }
  return IdSet(std::move(ids));
}

bool is_one_pixel(const std::optional<PixelBox>& window) {
  return window && window->first_i == window->last_i && window->first_j == window->last_j;
}

/// Knows what is admissible at the pixels that a trace is about.
class Judge {
 public:
  Judge(const View& view, const std::optional<PixelBox>& window, int threads, const Progress& progress)
      : width_(view.width) {
    if (is_one_pixel(window)) {
      list_ = exact::depth_list(view, window->first_i, window->first_j);
    } else {
      exact_ = std::make_unique<exact::ExactAnswer>(view, threads, progress);
      nearest_ = exact_->nearest(threads, progress);
      worker_ = std::make_unique<exact::Worker>(exact_->worker());
    }
  }

  bool admissible(int i, int j, std::uint32_t id) {
    if (!exact_) return is_nearest_of_list(id);
    const std::uint32_t nearest =
        nearest_
            .id[static_cast<std::size_t>(j) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(i)];
    if (id == nearest || nearest == background_id) return id == nearest;
    return worker_->covers(id, i, j) && worker_->compare_depth(id, nearest, i, j) == 0;
  }

 private:
  bool is_nearest_of_list(std::uint32_t id) const {
    for (std::size_t k = 0; k < list_.size() && (k == 0 || list_[k].tied); ++k) {
      if (list_[k].id == id) return true;
    }
    return false;
  }

  int width_;
  std::vector<exact::Fragment> list_;
  std::unique_ptr<exact::ExactAnswer> exact_;
  exact::Nearest nearest_;
  std::unique_ptr<exact::Worker> worker_;
};

/// What is printed: steps of one or two ranges.
struct Told {
  Recording first;
  Recording last;  ///< empty if `first` has all
  std::optional<Departure> departure;
};

/// Makes the run, finds the first departure, and keeps the steps that are printed.
Told tell(const TraceCommand& command, const TracedRun& run, const EventFilter& filter, Judge& judge) {
  DepartureFinder finder([&](int i, int j, std::uint32_t id) { return judge.admissible(i, j, id); });
  const TracedRun watched = [&](const EventListener& listener) {
    std::uint64_t wanted = 0;
    run([&](const Event& event) {
      const bool is_wanted = filter.wants(event);
      if (is_wanted) ++wanted;
      finder.tell(event, is_wanted ? wanted : 0);
      listener(event);
    });
  };
  const std::uint64_t from = command.from.value_or(1);
  const RecordedRange range = {.from = from,
                               .to = command.to.value_or(std::numeric_limits<std::uint64_t>::max()),
                               .most = command.to ? most_told : told_first + told_last};
  Told told;
  told.first = record(watched, filter, range);
  told.departure = finder.first();
  const std::uint64_t last = std::min(told.first.total, range.to);
  const std::uint64_t kept_to = from + told.first.events.size() - 1;
  if (from <= last && kept_to < last) {
    // One run more, for the end.
    if (!command.to) told.first.events.resize(told_first);
    told.last = record(run, filter, {.from = last - told_last + 1, .to = last, .most = told_last});
  }
  return told;
}

void print(const Told& told, std::ostream& out) {
  std::optional<std::uint64_t> departure;
  if (told.departure) departure = told.departure->step;
  bool printed_departure = false;
  const auto print_steps = [&](const Recording& recording) {
    for (std::size_t k = 0; k < recording.events.size(); ++k) {
      const std::uint64_t step = recording.first + k;
      printed_departure = printed_departure || step == departure;
      out << step_text(step, told.first.total, recording.events[k], departure);
    }
  };
  print_steps(told.first);
  if (!told.last.events.empty()) {
    out << left_out_text(told.last.first - told.first.first - told.first.events.size(), "step");
    print_steps(told.last);
  }
  if (departure && !printed_departure) {
    out << "\n" << step_text(*departure, told.first.total, told.departure->event, departure);
  }
  if (!departure) out << "\nNo step told here departs from the exact answer for good.\n";
}

void write_jsonl(const TraceCommand& command, const TracedRun& run, const EventFilter& filter) {
  const std::uint64_t from = command.from.value_or(1);
  const std::uint64_t to = command.to.value_or(std::numeric_limits<std::uint64_t>::max());
  write_file_atomically(*command.jsonl, [&](const std::filesystem::path& temporary) {
    OutputFile output(temporary);
    std::uint64_t step = 0;
    run([&](const Event& event) {
      if (!filter.wants(event)) return;
      ++step;
      if (from <= step && step <= to) output.write(to_json_line({step, event}) + "\n");
    });
    output.close();
  });
}

}  // namespace

void run(const TraceCommand& command, std::ostream& out) {
  for (const auto& file : {command.jsonl, command.gif}) {
    if (file) require_place(*file);
  }
  if (command.gif) require_ending("--gif", *command.gif, {".gif"});
  ProgressBar bar;
  const LoadedScene loaded = load_scene(command.picture.scene, bar);
  EventFilter filter = {.window = command.window};
  if (command.face) filter.about = triangles_of_face(loaded.scene, *command.face);
  const View view = choose_view(loaded.scene, command.picture);
  RenderOptions options = {command.picture.threads,
                           chosen_skips(command.picture.skips_off, {&command.algorithm, 1}), bar.listener()};
  options.window = command.window;
  const auto renderer =
      command.algorithm.algorithm->prepare(loaded.scene, command.algorithm.settings, options);
  const TracedRun traced = [&](const EventListener& listener) {
    Frame frame(view.width, view.height);
    renderer->trace(view, options, listener, frame);
  };
  if (command.window) filter.among = triangles_at(traced, *command.window, loaded.scene);
  Judge judge(view, command.window, command.picture.threads, bar.listener());
  const Told told = tell(command, traced, filter, judge);
  bar.erase();
  out << paragraph(loaded.scene.name + ", " + command.algorithm.text() + ": " + std::to_string(view.width) +
                   "x" + std::to_string(view.height) + ", " +
                   counted(loaded.scene.triangles.size(), "triangle") + "; " +
                   counted(told.first.total, "step") + ".")
      << "\n";
  print(told, out);
  if (command.gif) {
    const AnimatedSteps steps = {filter, command.from.value_or(1),
                                 std::min(told.first.total, command.to.value_or(told.first.total))};
    write_animation(view, traced, steps, command.backdrop, command.picture.threads, *command.gif);
    out << "\nWrote " << command.gif->string() << ".\n";
  }
  if (command.jsonl) {
    write_jsonl(command, traced, filter);
    out << "\nWrote " << command.jsonl->string() << ".\n";
  }
}

}  // namespace hsr
