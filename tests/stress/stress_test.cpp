#include "stress/stress.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "stress/refusals.h"
#include "stress/stress_json.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"

namespace {

using hsr::stress::Family;
using hsr::stress::FamilyResult;
using hsr::stress::Mode;
using hsr::stress::SeenProblem;
using hsr::stress::StressPlan;
using hsr::stress::StressResult;
using hsr::stress::Trial;

const Family& family_called(std::string_view name) {
  const auto found = std::ranges::find(hsr::stress::families(), name, &Family::name);
  REQUIRE(found != hsr::stress::families().end());
  return *found;
}

std::vector<Mode> modes_called(const std::string& specs) {
  return hsr::stress::modes_of(hsr::parse_algorithm_specs(specs));
}

/// The trials of a family from k to k.
FamilyResult tried(const Family& family, const std::string& specs, int first, int last) {
  FamilyResult result = {&family, {}};
  for (int k = first; k <= last; ++k) {
    result.trials.push_back(hsr::stress::run_trial(family, k, modes_called(specs), true, 1));
  }
  return result;
}

/// The least k from `first` to `last` at which one algorithm breaks.
std::optional<int> break_of(const std::string& family, const std::string& spec, int first, int last) {
  return hsr::stress::breakdown_point(tried(family_called(family), spec, first, last), 0);
}

/// The distance from a number to the next of its size in a format.
double float_step(double value) { return std::ldexp(1.0, std::max(std::ilogb(value), -126) - 23); }

/// Depths of board and patches as a format stores them: what is stored for 1 / eye depth, and the distance
/// between neighbouring numbers there. n is near, f is far.
struct Format {
  const char* name;
  std::function<double(double inverse, double n, double f)> stored;
  std::function<double(double stored)> step;
};

double window_depth(double inverse, double n, double f) { return (1.0 - n * inverse) * f / (f - n); }

std::vector<Format> formats() {
  return {
      {"eye", [](double inverse, double, double) { return 1.0 / inverse; }, float_step},
      {"reversed32", [](double inverse, double n, double f) { return n * (f * inverse - 1.0) / (f - n); },
       float_step},
      {"float32", window_depth, float_step},
      {"unorm24", window_depth, [](double) { return 1.0 / 16777215.0; }},
      {"unorm16", window_depth, [](double) { return 1.0 / 65535.0; }},
  };
}

/// Whether the two nearest surfaces of some pixel are less than a step apart where they are stored.
///
/// Numbers a step or more apart never round to the same; rounding keeps their order. Two that are less than
/// a step apart round to the same where no midpoint between neighbours lies between them. Over the hundreds
/// of pixels of an inclined plane they lie anywhere between neighbours, so as soon as they are less than a
/// step apart some of them do round to the same, and the board, which came first, stays before its patch.
bool some_pixel_within_a_step(const Family& family, int k, const Format& format) {
  const SeenProblem seen(family.make(k));
  const double n = seen.view.near_depth;
  const double f = seen.view.far_depth;
  for (int row = 0; row < seen.view.height; ++row) {
    const hsr::exact::DepthLists lists = seen.answer.depth_lists(row, row + 1);
    for (std::size_t pixel = 0; pixel + 1 < lists.begin.size(); ++pixel) {
      if (lists.begin[pixel + 1] - lists.begin[pixel] < 2) continue;
      const auto* list = lists.fragments.data() + lists.begin[pixel];
      if (list[0].id < list[1].id) continue;  // the board stays, and is right
      const double nearer = format.stored(1.0 / list[0].depth, n, f);
      const double farther = format.stored(1.0 / list[1].depth, n, f);
      const double step = std::max(format.step(nearer), format.step(farther));
      if (std::abs(farther - nearer) < step) return true;
    }
  }
  return false;
}

int predicted_break(const Family& family, const Format& format, int first, int last) {
  int k = first;
  while (k <= last && !some_pixel_within_a_step(family, k, format)) ++k;
  return k;
}

}  // namespace

TEST_CASE("stress: float32 positions hold the difficulty of a family up to the k that it states") {
  for (const Family& family : hsr::stress::families()) {
    CAPTURE(family.name);
    CHECK(family.least <= family.differs_to);
    CHECK(family.differs_to <= family.greatest);
    for (const int k : {family.least, family.differs_to, family.differs_to + 1}) {
      if (k > family.greatest) continue;
      CAPTURE(k);
      const std::uint64_t evidence = family.count_evidence(SeenProblem(family.make(k)));
      CHECK((evidence > 0) == (k <= family.differs_to));
    }
  }
}

TEST_CASE("stress: exact modes are right at every pixel and in every list, however hard") {
  std::string exact_ones;
  for (const hsr::Algorithm* algorithm : hsr::algorithm_catalog()) {
    if (!algorithm->traits.exact) continue;
    exact_ones.append(exact_ones.empty() ? "" : ",").append(algorithm->name);
  }
  // The largest scenes are for the long test.
  const std::map<std::string_view, int> large_from = {{"layers", 6},   {"on-centres", 3}, {"aimed", 9},
                                                      {"crossing", 7}, {"inside", 2},     {"mixed", 6}};
  StressResult result = {modes_called(exact_ones), {}};
  for (const Family& family : hsr::stress::families()) {
    const auto large = large_from.find(family.name);
    const int hardest = large == large_from.end() ? family.differs_to : large->second;
    result.families.push_back({&family, {hsr::stress::run_trial(family, hardest, result.modes, true, 1)}});
  }
  for (const std::string& broken : hsr::stress::broken_promises(result)) FAIL_CHECK(broken);
}

TEST_CASE("stress: depth formats break where two depths are less than a step of the format apart") {
  const Family& planes = family_called("planes-apart");
  for (const Format& format : formats()) {
    CAPTURE(format.name);
    const int predicted = predicted_break(planes, format, 8, 30);
    CHECK(break_of("planes-apart", "zbuffer[depth=" + std::string(format.name) + "]", 8, 30) == predicted);
  }
  // By hand: floats are 2^-24 to 2^-23 of themselves apart. And a step of 16 bits is 2^-16, of which depth at
  // w = 1.3 has near far / (far - near) / w = 0.2 to 0.25: two bits more than 2^-16, 14 instead of 16.
  CHECK(break_of("planes-apart", "zbuffer[depth=eye]", 20, 26) == 24);
  CHECK(break_of("planes-apart", "zbuffer[depth=unorm16]", 10, 18) == 14);
}

TEST_CASE("stress: the farther near is from far the sooner depth formats break, but for two") {
  const Family& ratio = family_called("depth-ratio");
  for (const Format& format : formats()) {
    CAPTURE(format.name);
    const int last = std::string(format.name) == "reversed32" ? 45 : 12;
    const int first = last == 45 ? 38 : 1;
    const int predicted = predicted_break(ratio, format, first, last);
    const std::optional<int> broken =
        break_of("depth-ratio", "zbuffer[depth=" + std::string(format.name) + "]", first, last);
    CHECK(broken.value_or(last + 1) == predicted);
  }
  // eye never does, as it knows nothing of near; reversed32 where its numbers come to float's smallest.
  CHECK(!break_of("depth-ratio", "zbuffer[depth=eye]", 40, 45));
}

TEST_CASE("stress: corners rounded to a grid miss an edge that is less than half a step beside a centre") {
  // The centre is on the grid, and the edge 2^-k beside it. Rounded to multiples of 2^-s it stays where it is
  // for k <= s. At k = s + 1, just half a step, it is rounded away from zero, which is away from the centre;
  // at k = s + 2 it is rounded onto the centre, which both boards then cover.
  for (const int bits : {2, 4, 8, 16}) {
    CAPTURE(bits);
    CHECK(break_of("near-centres", "zbuffer[snap=" + std::to_string(bits) + "]", 0, 20) == bits + 2);
  }
}

TEST_CASE("stress: an epsilon breaks where what is between two planes is less than it") {
  // Newell's sign compares n · p with the sum of the sizes of its terms, which for depths of about 1 is 1 to
  // 4 times as large as what it adds: 2^-k < 10^-9 times that, from k = 28 to 30 on.
  const std::optional<int> broken = break_of("planes-apart", "newell[predicates=epsilon]", 20, 34);
  REQUIRE(broken);
  CHECK(*broken >= 28);
  CHECK(*broken <= 30);
}

TEST_CASE("stress: float rays break where float coordinates do") {
  // Relative to the eye the far end of Kettner's line is at 23.5, where floats are 2^-19 apart and so off by
  // up to 2^-20: the line misses its pixels, 2^-k apart, from about k = 20 on; errors of several operations
  // that add up are worth a bit or two.
  const std::optional<int> broken = break_of("kettner", "raycast[test=watertight]", 14, 24);
  REQUIRE(broken);
  CHECK(*broken >= 18);
  CHECK(*broken <= 21);
}

TEST_CASE("stress: orders of whole faces break at the first cycle, and cuts mend it") {
  for (const char* spec : {"painter", "newell[split=off]"}) {
    CAPTURE(spec);
    CHECK(break_of("bars", spec, 3, 3) == 3);
    CHECK(break_of("crossing", spec, 2, 2) == 2);
  }
}

TEST_CASE("stress: lists with room for four break where five layers lie over each other") {
  CHECK(break_of("layers", "abuffer[limit=4]", 0, 5) == 3);
}

TEST_CASE("stress: NaN, infinity and cameras that are none are refused with a reason") {
  for (const hsr::stress::Refusal& refusal : hsr::stress::try_refusals()) {
    CAPTURE(refusal.what);
    CHECK(refusal.refused());
  }
}

TEST_CASE("stress: a stopped run goes on with the trials that it has, and comes to the same") {
  const Family& family = family_called("bars");
  const StressPlan plan = {{&family}, modes_called("painter,zbuffer"), true, 1};
  std::vector<std::string> kept;
  const auto keep = [&](const Family&, const Trial& trial) { kept.push_back(hsr::stress::to_json(trial)); };
  const auto nothing = [](const Family&, int) { return std::optional<Trial>(); };
  int asked = 0;
  const auto stop_soon = [&](std::string_view, double) { return ++asked <= 3; };
  const StressResult first = hsr::stress::run_stress(plan, stop_soon, {nothing, keep});
  REQUIRE(kept.size() == 3);
  CHECK(first.families.front().trials.size() == 3);
  const auto find = [&](const Family&, int k) -> std::optional<Trial> {
    for (const std::string& json : kept) {
      const Trial trial = hsr::stress::trial_of_json(json, plan.modes);
      if (trial.k == k) return trial;
    }
    return std::nullopt;
  };
  const StressResult second = hsr::stress::run_stress(plan, {}, {find, keep});
  const std::vector<int> wanted = hsr::stress::difficulties(family, true);
  CHECK(kept.size() == wanted.size());
  REQUIRE(second.families.front().trials.size() == wanted.size());
  for (std::size_t place = 0; place < wanted.size(); ++place) {
    CHECK(second.families.front().trials[place].k == wanted[place]);
  }
  CHECK(hsr::stress::breakdown_point(second.families.front(), 0) == 3);
  CHECK(!hsr::stress::breakdown_point(second.families.front(), 1));
}

TEST_CASE("stress: the command writes tables, data, plots and a page, and says where what breaks") {
  const hsr::test::TemporaryFolder folder;
  const hsr::test::ProgramRun run =
      hsr::test::run_program({"stress", "bars", "-a", "painter,zbuffer", "--quick", "-o", folder / "out"});
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("No exact mode is wrong") != std::string::npos);
  CHECK(hsr::test::content_of(folder / "out/breakdown.csv").find("painter,3") != std::string::npos);
  CHECK(hsr::test::content_of(folder / "out/stress.json").find("\"painter\": 3") != std::string::npos);
  CHECK(hsr::test::content_of(folder / "out/stress.html").find("k bars in a cycle") != std::string::npos);
  CHECK(hsr::test::content_of(folder / "out/bars.dat").find("painter") != std::string::npos);
  CHECK(hsr::test::run_program({"stress", "no-such-family"}).exit_code == 2);
}
