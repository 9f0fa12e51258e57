#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "stress/stress.h"

TEST_CASE("stress: every exact mode is right at every difficulty of every family") {
  hsr::stress::StressPlan plan;
  for (const hsr::stress::Family& family : hsr::stress::families()) plan.families.push_back(&family);
  for (hsr::stress::Mode& mode : hsr::stress::catalogue_modes()) {
    if (mode.exact) plan.modes.push_back(std::move(mode));
  }
  plan.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const hsr::stress::TrialStore nothing = {[](const auto&, int) { return std::nullopt; },
                                           [](const auto&, const auto&) {}};
  const hsr::stress::StressResult result = hsr::stress::run_stress(plan, {}, nothing);
  for (const std::string& broken : hsr::stress::broken_promises(result)) FAIL_CHECK(broken);
}
