#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scene/progress.h"
#include "stress/family.h"
#include "stress/modes.h"

namespace hsr::stress {

/// How one mode did on one problem.
struct Outcome {
  std::string not_run;            ///< why it was not tried; then the rest is 0
  std::uint64_t wrong = 0;        ///< pixels, as exact::Errors has them
  std::uint64_t holes = 0;        ///< pixels
  std::uint64_t leaks = 0;        ///< pixels
  std::uint64_t list_errors = 0;  ///< missing, extra and misplaced fragments; of exact modes that keep lists
  std::uint64_t questions = 0;    ///< whether a triangle covers a sample, or is nearer: what was asked
  std::uint64_t to_double = 0;    ///< those that a filter in float left open; all, where there is none
  std::uint64_t to_exact = 0;     ///< those that doubles left open too
  double ms = 0.0;                ///< least time of a few renderings

  std::uint64_t failing() const { return wrong + holes + leaks; }
};

/// One problem, put to all modes.
struct Trial {
  int k = 0;
  std::uint64_t triangles = 0;
  std::uint64_t pixels = 0;
  std::uint64_t covered = 0;      ///< pixels
  std::uint64_t evidence = 0;     ///< what the family counts
  std::vector<Outcome> outcomes;  ///< in the order of the modes
};

/// What came of a family.
struct FamilyResult {
  const Family* family = nullptr;
  std::vector<Trial> trials;  ///< by ascending k
};

struct StressPlan {
  std::vector<const Family*> families;
  std::vector<Mode> modes;
  bool quick = false;
  int threads = 1;
};

struct StressResult {
  std::vector<Mode> modes;
  std::vector<FamilyResult> families;
};

/// Puts one problem to all modes; `quick` leaves out slow ones on large scenes.
Trial run_trial(const Family& family, int k, const std::vector<Mode>& modes, bool quick, int threads);

/// Where trials of an earlier run come from, and where those of this one go.
struct TrialStore {
  std::function<std::optional<Trial>(const Family&, int k)> find;
  std::function<void(const Family&, const Trial&)> keep;
};

/// Tries all families of the plan in order, but for trials that the store has. `progress` is told how far all
/// of it is; if it asks to stop, no further trial is begun.
StressResult run_stress(const StressPlan& plan, const Progress& progress, const TrialStore& store);

/// The least k at which a mode, by its place, fails at some pixel.
std::optional<int> breakdown_point(const FamilyResult& result, std::size_t mode);

/// What is wrong with the families or with modes that promise the exact answer; empty if nothing is: evidence
/// where there should be none or none where there should be some, pixels or list fragments of an exact mode
/// that are wrong.
std::vector<std::string> broken_promises(const StressResult& result);

}  // namespace hsr::stress
