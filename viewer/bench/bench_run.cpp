#include "bench/bench_run.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "bench/cell_runner.h"
#include "picture.h"
#include "report/machine.h"
#include "scene/errors.h"
#include "text_layout.h"

namespace hsr::bench {
namespace {

std::string key_of(const Cell& cell) {
  return std::string(name_of(cell.question)) + " | " + cell.scene + " | " + std::to_string(cell.size.width) +
         "x" + std::to_string(cell.size.height);
}

std::string json_array(const std::vector<RunRecord>& records) {
  std::string text = "[";
  for (const RunRecord& record : records) text += (text.size() == 1 ? "" : ",") + to_json(record);
  return text + "]";
}

std::vector<RunRecord> records_from(const std::string& array) {
  std::vector<RunRecord> records;
  for (const nlohmann::ordered_json& json : nlohmann::ordered_json::parse(array))
    records.push_back(record_from_json(json.dump()));
  return records;
}

/// Who was stopped, or nearly, need not try something larger.
void give_up(const std::vector<RunRecord>& records, std::map<std::string, std::string>& given_up) {
  for (const RunRecord& record : records) {
    if (record.failed.empty() || record.question == Question::tradeoff) continue;
    given_up.try_emplace(record.name, "left out: " + record.failed + " at " +
                                          grouped(static_cast<std::uint64_t>(record.parameter)));
  }
}

std::string repeats_sentence(const BenchPlan& plan, const std::vector<RunRecord>& runs) {
  std::size_t settled = 0;
  std::size_t timed = 0;
  for (const RunRecord& run : runs) {
    timed += run.render.ms.empty() ? 0 : 1;
    settled += run.settled ? 1 : 0;
  }
  const RepeatLimits& limits = plan.limits;
  return "All who run on one scene at one size did so in turn, after a run each that does not count, until "
         "the "
         "middle half of the times of each lay within " +
         significant(100.0 * limits.settled, 2) + " % of their median, at least " +
         std::to_string(limits.least) + " and at most " + std::to_string(limits.most) + " times or for " +
         significant(limits.seconds, 2) + " s each. That was reached for " + grouped(settled) + " of " +
         grouped(timed) + "; the spread of every time is given. A run that took longer than " +
         significant(plan.most_seconds, 3) + " s was stopped and is left out.";
}

constexpr double steps_of_1974 = 20.0;

// Depth sort of many faces takes much longer than anything else, and is what the table is about.
constexpr double times_for_1974 = 10.0;

/// Better a word on a scene that is none now than after all those before it. Files are read when their turn
/// comes.
void require_scenes(const BenchPlan& plan) {
  for (const Cell& cell : plan.cells) {
    std::error_code ignored;
    if (cell.question != Question::tradeoff || std::filesystem::exists(cell.scene, ignored)) continue;
    ReadReport report;
    (void)open_scene(cell.scene, report, {});
  }
}

}  // namespace

std::string TimeLeft::text(double milliseconds) const {
  if (done_ <= 0.0) return {};
  const double seconds = milliseconds / 1000.0 * std::max(0.0, total_ - done_) / done_;
  constexpr double minute = 60.0;
  if (seconds < minute) return std::to_string(static_cast<int>(std::ceil(seconds))) + " s left";
  return std::to_string(static_cast<int>(std::ceil(seconds / minute))) + " min left";
}

std::string identity(const BenchCommand& command) {
  std::string text = command.quick ? "quick" : "full";
  for (const std::string& scene : command.chosen_scenes) text += " scene " + scene;
  for (const std::string& scene : command.scenes) text += " scene " + scene;
  for (const std::string& question : command.only) text += " only " + question;
  for (const Size& size : command.sizes)
    text += " size " + std::to_string(size.width) + "x" + std::to_string(size.height);
  for (const AlgorithmSpec& spec : command.algorithms) text += " algorithm " + spec.text();
  for (const int threads : command.threads) text += " threads " + std::to_string(threads);
  if (command.seconds) text += " seconds " + significant(*command.seconds, 6);
  for (const PeerEntry& peer : peer_table()) {
    if (command.peers && !peer_program(peer).empty()) text += " peer " + std::string(peer.name);
  }
  for (const auto& [name, value] : report::this_machine().rows()) text += "; " + name + " " + value;
  return text;
}

BenchReport run_plan(const BenchPlan& plan, report::Journal* journal, const Progress& progress) {
  require_scenes(plan);
  double total = steps_of_1974 * static_cast<double>(plan.faces_of_1974.size());
  for (const Cell& cell : plan.cells) total += static_cast<double>(cell.entries.size());
  TimeLeft left(total);
  const Stopwatch stopwatch;
  const auto tell = [&](const std::string& what) {
    const std::string time = left.text(stopwatch.milliseconds());
    (void)report_progress(progress, what + (time.empty() ? "" : ", " + time), left.share());
  };
  const auto earlier = [&](const std::string& key) {
    return journal != nullptr ? journal->find(key) : std::nullopt;
  };
  BenchReport report;
  report.machine = report::this_machine().rows();
  std::optional<BenchScene> scene;
  std::map<Question, std::map<std::string, std::string>> given_up;
  for (const Cell& cell : plan.cells) {
    const std::string key = key_of(cell);
    std::vector<RunRecord> records;
    if (const std::optional<std::string> kept = earlier(key)) {
      records = records_from(*kept);
      left.without(static_cast<double>(cell.entries.size()));
    } else {
      tell(cell.scene);
      if (!scene || scene->name != cell.scene) scene = load_bench_scene(cell.scene);
      records = run_cell(cell, *scene, plan, given_up[cell.question], [&] {
        left.step();
        tell(cell.scene);
      });
      if (journal != nullptr) journal->add(key, json_array(records));
    }
    give_up(records, given_up[cell.question]);
    report.runs.insert(report.runs.end(), records.begin(), records.end());
  }
  for (const int faces : plan.faces_of_1974) {
    const std::string key = "1974 | " + std::to_string(faces);
    tell("the table of 1974");
    const std::optional<std::string> kept = earlier(key);
    const std::vector<Cost1974> costs =
        kept ? costs_from_json(*kept) : costs_of_1974(faces, times_for_1974 * plan.most_seconds);
    if (!kept && journal != nullptr) journal->add(key, to_json(costs));
    report.costs.insert(report.costs.end(), costs.begin(), costs.end());
    left.step(steps_of_1974);
  }
  report.repeats = repeats_sentence(plan, report.runs);
  return report;
}

}  // namespace hsr::bench
