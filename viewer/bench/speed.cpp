#include "bench/speed.h"

#include <algorithm>
#include <memory>

#include "bench/algorithm_contestant.h"
#include "bench/peers.h"
#include "picture.h"
#include "scene/errors.h"

namespace hsr::bench {
namespace {

/// Who is to take part in a race, before anything is prepared.
struct Entry {
  std::string name;
  bool peer = false;
  std::function<std::unique_ptr<Contestant>()> enter;
};

/// The fast versions and, to see what that brings, the textbook z-buffer.
std::vector<AlgorithmSpec> usual_algorithms() {
  std::vector<AlgorithmSpec> specs;
  for (const Algorithm* algorithm : algorithm_catalog()) {
    if (algorithm->variant_of.empty() || !algorithm->traits.exact || algorithm->traits.paints_faces) continue;
    specs.push_back(parse_algorithm_spec(algorithm->name));
    for (const Setting& setting : algorithm->settings) {
      if (setting.name != "exact") continue;  // the same code, guessing: what being right costs
      specs.push_back(parse_algorithm_spec(std::string(algorithm->name) + "[exact=no]"));
    }
  }
  specs.push_back(parse_algorithm_spec("zbuffer"));
  return specs;
}

bool can(const Algorithm& algorithm, Task task) {
  if (task == Task::lists) return algorithm.traits.keeps_lists;
  return task == Task::nearest || !algorithm.variant_of.empty();
}

std::vector<Entry> entries_of(const SpeedPlan& plan, const SpeedRace& race, const View& view) {
  std::vector<Entry> entries;
  for (const AlgorithmSpec& spec : plan.algorithms.empty() ? usual_algorithms() : plan.algorithms) {
    if (!can(*spec.algorithm, race.task)) continue;
    const bool fast = !spec.algorithm->variant_of.empty();
    for (const std::string& set : fast ? plan.instruction_sets : std::vector<std::string>{""}) {
      RenderOptions options;
      options.threads = race.threads;
      options.instruction_set = set;
      entries.push_back({spec.text() + (set.empty() ? "" : " " + set), false, [spec, options, &race, &view] {
                           return algorithm_contestant(spec, race.task, view, options);
                         }});
    }
  }
  if (!plan.peers) return entries;
  for (const PeerEntry& peer : peer_table()) {
    if (peer.task != race.task || peer_program(peer).empty()) continue;
    entries.push_back({std::string(peer.name), true, [&peer, &race] {
                         return start(peer, std::string(race.scene.scene), race.size.width, race.size.height,
                                      race.threads);
                       }});
  }
  return entries;
}

/// The exact answer that every picture is held against.
struct Truth {
  exact::ExactAnswer answer;
  exact::Nearest nearest;
  Truth(const View& view, int threads) : answer(view, threads), nearest(answer.nearest(threads)) {}
};

void run_race(const SpeedPlan& plan, const View& view, const Truth& truth,
              const std::function<bool()>& keep_going, SpeedRace& race) {
  std::vector<std::unique_ptr<Contestant>> contestants;
  std::vector<Contestant*> running;
  std::vector<std::size_t> row_of;
  for (const Entry& entry : entries_of(plan, race, view)) {
    SpeedRow row;
    row.name = entry.name;
    row.peer = entry.peer;
    try {
      if (!keep_going()) return;
      contestants.push_back(entry.enter());
      row.prepare_ms = contestants.back()->prepare_ms();
      running.push_back(contestants.back().get());
      row_of.push_back(race.rows.size());
    } catch (const InputError& error) {
      row.failed = error.what();
    }
    race.rows.push_back(std::move(row));
  }
  if (running.empty()) return;
  const std::vector<Timing> timings = bench::race(running, plan.limits, keep_going);
  for (std::size_t k = 0; k < running.size(); ++k) {
    SpeedRow& row = race.rows[row_of[k]];
    row.timing = timings[k];
    row.errors = exact::measure_errors(running[k]->picture(), truth.answer, truth.nearest, {});
  }
}

}  // namespace

std::optional<std::size_t> fastest_peer(const SpeedRace& race) {
  std::optional<std::size_t> fastest;
  for (std::size_t k = 0; k < race.rows.size(); ++k) {
    const SpeedRow& row = race.rows[k];
    if (!row.peer || row.timing.ms.empty()) continue;
    if (!fastest || row.timing.median() < race.rows[*fastest].timing.median()) fastest = k;
  }
  return fastest;
}

void run_speed(const SpeedPlan& plan, const Progress& progress,
               const std::function<void(const SpeedRace&)>& finished) {
  constexpr Task tasks[] = {Task::nearest, Task::prepare_and_nearest, Task::lists};
  const std::size_t races = plan.scenes.size() * plan.sizes.size() * plan.threads.size() * std::size(tasks);
  std::size_t done = 0;
  bool going = true;
  const auto keep_going = [&] {
    going =
        going && report_progress(progress, "racing", static_cast<double>(done) / static_cast<double>(races));
    return going;
  };
  for (const SpeedScene& scene : plan.scenes) {
    ReadReport ignored;
    const Scene loaded = open_scene(std::string(scene.scene), ignored, {});
    for (const Size size : plan.sizes) {
      PictureOptions options;
      options.size = size;
      const View view = choose_view(loaded, options);
      if (!keep_going()) return;
      const Truth truth(view, *std::ranges::max_element(plan.threads));
      for (const int threads : plan.threads) {
        for (const Task task : tasks) {
          SpeedRace race = {scene, loaded.triangles.size(), size, threads, task, truth.nearest.covered, {}};
          run_race(plan, view, truth, keep_going, race);
          if (!going) return;
          ++done;
          if (!race.rows.empty()) finished(race);
        }
      }
    }
  }
}

}  // namespace hsr::bench
