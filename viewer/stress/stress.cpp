#include "stress/stress.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>

#include "exact/errors.h"
#include "exact/list_errors.h"
#include "parallel.h"
#include "picture.h"
#include "scene/errors.h"
#include "stress/peer_trial.h"
#include "text_layout.h"

namespace hsr::stress {
namespace {

/// How large a scene a mode is tried on. The textbook version of Newell's algorithm compares nearly every
/// pair of triangles where all are at about the same depth, and without its last test cuts whatever it can.
std::uint64_t most_triangles(const Mode& mode, bool quick) {
  if (mode.spec.algorithm->name != "newell") return std::numeric_limits<std::uint64_t>::max();
  const std::string& tests = mode.spec.settings.find("tests")->second;
  if (tests != "all" && !tests.ends_with("apart")) return 100;
  return quick ? 1000 : 4000;
}

std::uint64_t counter(const RenderReport& report, std::string_view name) {
  const auto found = report.counters.find(name);
  return found == report.counters.end() ? 0 : found->second;
}

void count_questions(const RenderReport& report, Outcome& outcome) {
  if (report.counters.contains("lanes")) {
    outcome.questions = counter(report, "lanes");
    outcome.to_double = counter(report, "lanes_to_double");
    outcome.to_exact = counter(report, "lanes_to_exact");
    return;
  }
  outcome.to_exact = counter(report, "exact_evaluations");
  outcome.questions =
      std::max({counter(report, "fragments"), counter(report, "triangle_tests"), outcome.to_exact});
  outcome.to_double = outcome.questions;
}

void note_errors(const exact::Errors& errors, Outcome& outcome) {
  outcome.wrong = errors.wrong;
  outcome.holes = errors.holes;
  outcome.leaks = errors.leaks;
}

std::uint64_t wrong_fragments(Renderer& renderer, const SeenProblem& seen) {
  Frame frame(seen.view.width, seen.view.height);
  frame.lists.emplace();
  (void)renderer.render(seen.view, {}, frame);
  const exact::ListErrors errors =
      exact::measure_list_errors(*frame.lists, seen.answer, seen.view.width, {0, seen.view.height}, 1);
  return errors.missing + errors.extra + errors.inversions;
}

Outcome try_algorithm(const Mode& mode, const SeenProblem& seen, bool quick) {
  constexpr int most_renderings = 3;
  constexpr double worth_repeating = 20.0;  // milliseconds
  Outcome outcome;
  const std::uint64_t most = most_triangles(mode, quick);
  if (seen.problem.scene.triangles.size() > most) {
    outcome.not_run = "more than " + counted(most, "triangle");
    return outcome;
  }
  const auto renderer = mode.spec.algorithm->prepare(seen.problem.scene, mode.spec.settings, {});
  for (int rendering = 0; rendering < most_renderings; ++rendering) {
    if (rendering > 0 && outcome.ms > worth_repeating) break;
    Frame frame(seen.view.width, seen.view.height);
    const Stopwatch stopwatch;
    const RenderReport report = renderer->render(seen.view, {}, frame);
    const double ms = stopwatch.milliseconds();
    outcome.ms = rendering == 0 ? ms : std::min(outcome.ms, ms);
    if (rendering > 0) continue;
    count_questions(report, outcome);
    note_errors(exact::measure_errors(frame, seen.answer, seen.nearest, {}), outcome);
  }
  if (mode.exact && mode.spec.algorithm->traits.keeps_lists) {
    outcome.list_errors = wrong_fragments(*renderer, seen);
  }
  return outcome;
}

Outcome try_peer(const Mode& mode, const SeenProblem& seen) {
  Outcome outcome;
  try {
    const PeerPicture picture = picture_of_peer(*mode.peer, seen.problem);
    outcome.ms = picture.ms;
    note_errors(exact::measure_errors(picture.frame, seen.answer, seen.nearest, {}), outcome);
  } catch (const InputError& error) {
    outcome.not_run = error.what();
  }
  return outcome;
}

/// How far a run is, in trials, and in words how long the rest will take.
class Clock {
 public:
  explicit Clock(std::size_t trials) : trials_(trials) {}

  void finish_one() { ++done_; }
  void skip_one() { --trials_; }
  double done() const {
    return trials_ == 0 ? 1.0 : static_cast<double>(done_) / static_cast<double>(trials_);
  }
  std::string words(const Family& family, int k) const {
    std::string text = std::string(family.name) + " k = " + std::to_string(k);
    if (done_ == 0) return text;
    const double left = stopwatch_.milliseconds() / 1000.0 * static_cast<double>(trials_ - done_) /
                        static_cast<double>(done_);
    const bool minutes = left >= 90.0;
    return text + ", about " + std::to_string(std::lround(minutes ? left / 60.0 : left)) +
           (minutes ? " min left" : " s left");
  }

 private:
  std::size_t trials_;
  std::size_t done_ = 0;
  Stopwatch stopwatch_;
};

}  // namespace

Trial run_trial(const Family& family, int k, const std::vector<Mode>& modes, bool quick, int threads) {
  const SeenProblem seen(family.make(k));
  Trial trial;
  trial.k = k;
  trial.triangles = seen.problem.scene.triangles.size();
  trial.pixels = seen.nearest.id.size();
  trial.covered = seen.nearest.covered;
  trial.evidence = family.count_evidence(seen);
  trial.outcomes.resize(modes.size());
  parallel_for(static_cast<int>(modes.size()), threads, [&](int place) {
    const Mode& mode = modes[static_cast<std::size_t>(place)];
    trial.outcomes[static_cast<std::size_t>(place)] =
        mode.peer == nullptr ? try_algorithm(mode, seen, quick) : try_peer(mode, seen);
  });
  return trial;
}

StressResult run_stress(const StressPlan& plan, const Progress& progress, const TrialStore& store) {
  std::size_t trials = 0;
  for (const Family* family : plan.families) trials += difficulties(*family, plan.quick).size();
  Clock clock(trials);
  StressResult result = {plan.modes, {}};
  for (const Family* family : plan.families) {
    FamilyResult& current = result.families.emplace_back(FamilyResult{family, {}});
    for (const int k : difficulties(*family, plan.quick)) {
      if (std::optional<Trial> earlier = store.find(*family, k)) {
        current.trials.push_back(std::move(*earlier));
        clock.skip_one();
        continue;
      }
      if (!report_progress(progress, clock.words(*family, k), clock.done())) return result;
      current.trials.push_back(run_trial(*family, k, plan.modes, plan.quick, plan.threads));
      clock.finish_one();
      store.keep(*family, current.trials.back());
    }
  }
  return result;
}

std::optional<int> breakdown_point(const FamilyResult& result, std::size_t mode) {
  const auto broken = std::ranges::find_if(
      result.trials, [mode](const Trial& trial) { return trial.outcomes[mode].failing() > 0; });
  return broken == result.trials.end() ? std::nullopt : std::optional(broken->k);
}

std::vector<std::string> broken_promises(const StressResult& result) {
  std::vector<std::string> broken;
  for (const FamilyResult& family : result.families) {
    for (const Trial& trial : family.trials) {
      const std::string where = std::string(family.family->name) + " k = " + std::to_string(trial.k) + ": ";
      const bool tells = trial.k <= family.family->differs_to;
      if (tells != (trial.evidence > 0)) {
        broken.push_back(where + grouped(trial.evidence) + " " + std::string(family.family->evidence));
      }
      for (std::size_t mode = 0; mode < result.modes.size(); ++mode) {
        const Outcome& outcome = trial.outcomes[mode];
        if (!result.modes[mode].exact || outcome.failing() + outcome.list_errors == 0) continue;
        broken.push_back(where + result.modes[mode].name + " has " +
                         counted(outcome.failing(), "wrong pixel") + " and " +
                         counted(outcome.list_errors, "wrong list fragment"));
      }
    }
  }
  return broken;
}

}  // namespace hsr::stress
