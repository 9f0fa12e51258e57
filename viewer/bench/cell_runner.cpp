#include "bench/cell_runner.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "bench/algorithm_contestant.h"
#include "picture.h"
#include "scene/errors.h"
#include "text_layout.h"
#include "truth.h"

namespace hsr::bench {
namespace {

/// An algorithm of the kit whose runs are stopped when they take too long.
class LimitedContestant : public Contestant {
 public:
  LimitedContestant(const Entry& entry, const View& view, double most_seconds) : limit_(most_seconds) {
    RenderOptions options;
    options.threads = entry.threads;
    if (!entry.skip_off.empty()) options.skips_off.insert(entry.skip_off);
    options.progress = limit_.progress();
    limit_.start();
    contestant_ = algorithm_contestant(entry.spec, Task::nearest, view, options);
    limit_.require_kept();
  }

  double run() override {
    limit_.start();
    const double ms = contestant_->run();
    limit_.require_kept();
    return ms;
  }
  Frame picture() override { return contestant_->picture(); }
  double prepare_ms() const override { return contestant_->prepare_ms(); }

 private:
  TimeLimit limit_;
  std::unique_ptr<Contestant> contestant_;
};

std::unique_ptr<Contestant> enter(const Entry& entry, const Cell& cell, const View& view,
                                  double most_seconds) {
  if (entry.peer != nullptr)
    return start(*entry.peer, cell.scene, cell.size.width, cell.size.height, entry.threads);
  return std::make_unique<LimitedContestant>(entry, view, most_seconds);
}

RunRecord record_of(const Entry& entry, const Cell& cell, const BenchScene& scene, std::uint64_t covered) {
  RunRecord record;
  record.question = cell.question;
  record.scene = cell.scene;
  record.triangles = scene.scene.triangles.size();
  record.width = cell.size.width;
  record.height = cell.size.height;
  record.covered = covered;
  record.parameter = cell.parameter;
  record.name = entry.name();
  record.algorithm = entry.peer != nullptr ? std::string(entry.peer->program) : entry.spec.algorithm->name;
  record.peer = entry.peer != nullptr;
  record.only_geometry = record.peer || !entry.spec.algorithm->variant_of.empty();
  record.threads = entry.threads;
  record.skip_off = entry.skip_off;
  record.load_ms = scene.load_ms;
  return record;
}

/// Renders once more, with colours, and compares with the exact answer.
void take_errors(const Entry& entry, const View& view, const Truth& truth, double most_seconds, bool lists,
                 RunRecord& record) {
  TimeLimit limit(2.0 * most_seconds);
  RenderOptions options;
  options.threads = entry.threads;
  if (!entry.skip_off.empty()) options.skips_off.insert(entry.skip_off);
  options.progress = limit.progress();
  limit.start();
  const Stopwatch stopwatch;
  const auto renderer = entry.spec.algorithm->prepare(*view.scene, entry.spec.settings, options);
  record.prepare_ms = std::min(record.prepare_ms, stopwatch.milliseconds());
  Frame frame(view.width, view.height);
  const RenderReport report = renderer->render(view, options, frame);
  limit.require_kept();
  record.bytes = report.bytes;
  record.skipped = report.skipped;
  record.counters = report.counters;
  record.errors =
      exact::measure_errors(frame, truth.answer, truth.nearest, truth.wanted_colors(*entry.spec.algorithm));
  if (!lists || !entry.spec.algorithm->traits.keeps_lists || !entry.skip_off.empty()) return;
  // It takes a run for each few rows of the picture.
  constexpr double most_milliseconds = 1000.0;
  if (record.render.median() > most_milliseconds) return;
  options.progress = {};
  record.lists = measure_lists(*renderer, view, options, truth);
}

/// Some entries that run in turn.
void run_batch(std::span<const Entry> entries, const Cell& cell, const View& view, const Truth& truth,
               const BenchPlan& plan, const std::function<void()>& ran, std::span<RunRecord> records) {
  std::vector<std::unique_ptr<Contestant>> contestants;
  std::vector<Contestant*> running;
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (!records[k].failed.empty()) continue;
    try {
      contestants.push_back(enter(entries[k], cell, view, plan.most_seconds));
      records[k].prepare_ms = contestants.back()->prepare_ms();
      running.push_back(contestants.back().get());
      places.push_back(k);
    } catch (const InputError& error) {
      records[k].failed = error.what();
    }
  }
  const std::vector<Repeats> repeats = repeat_in_turn(running, plan.limits, [] { return true; });
  for (std::size_t k = 0; k < running.size(); ++k) {
    RunRecord& record = records[places[k]];
    record.render = repeats[k].timing;
    record.settled = repeats[k].settled;
    record.failed = repeats[k].failed;
    if (!record.failed.empty()) continue;
    try {
      if (record.peer)
        record.errors = exact::measure_errors(running[k]->picture(), truth.answer, truth.nearest, {});
      else
        take_errors(entries[places[k]], view, truth, plan.most_seconds, cell.all_errors, record);
    } catch (const InputError& error) {
      record.failed = error.what();
    }
    ran();
  }
}

/// How many entries may be ready to run at once: each has a frame and may have a hierarchy.
std::size_t batch_size(const Cell& cell, const Scene& scene) {
  constexpr double bytes_per_pixel = 24.0;
  constexpr double bytes_per_triangle = 300.0;
  constexpr double most_bytes = 1.5e9;
  const double each = bytes_per_pixel * cell.size.width * cell.size.height +
                      bytes_per_triangle * static_cast<double>(scene.triangles.size());
  return static_cast<std::size_t>(std::max(1.0, most_bytes / each));
}

}  // namespace

void TimeLimit::start() {
  stopped_ = false;
  end_ = std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                                std::chrono::duration<double>(seconds_));
}

Progress TimeLimit::progress() {
  return [this](std::string_view, double) {
    if (std::chrono::steady_clock::now() > end_) stopped_ = true;
    return !stopped_;
  };
}

void TimeLimit::require_kept() const {
  if (stopped_) throw InputError("stopped after " + significant(seconds_, 3) + " s");
}

BenchScene load_bench_scene(const std::string& name) {
  const Stopwatch stopwatch;
  ReadReport report;
  BenchScene scene = {name, open_scene(name, report, {}), 0.0};
  scene.load_ms = stopwatch.milliseconds();
  return scene;
}

std::vector<RunRecord> run_cell(const Cell& cell, const BenchScene& scene, const BenchPlan& plan,
                                const std::map<std::string, std::string>& given_up,
                                const std::function<void()>& ran) {
  PictureOptions options;
  options.size = cell.size;
  const View view = choose_view(scene.scene, options);
  const bool antialiased = cell.all_errors && std::ranges::any_of(cell.entries, [](const Entry& entry) {
                             return entry.peer == nullptr && entry.spec.algorithm->traits.antialiased;
                           });
  const Truth truth(view, antialiased, plan.all_threads, {});
  std::vector<RunRecord> records;
  for (const Entry& entry : cell.entries) {
    records.push_back(record_of(entry, cell, scene, truth.nearest.covered));
    const auto found = given_up.find(entry.name());
    if (found != given_up.end()) records.back().failed = found->second;
  }
  const std::size_t at_once = batch_size(cell, scene.scene);
  for (std::size_t first = 0; first < cell.entries.size(); first += at_once) {
    const std::size_t count = std::min(at_once, cell.entries.size() - first);
    run_batch(std::span(cell.entries).subspan(first, count), cell, view, truth, plan, ran,
              std::span(records).subspan(first, count));
  }
  return records;
}

}  // namespace hsr::bench
