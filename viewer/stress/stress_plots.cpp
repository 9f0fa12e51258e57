#include "stress/stress_plots.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "text_layout.h"

namespace hsr::stress {
namespace {

/// Who is drawn, in this order, and always looks the same. Of those that fail alike only the first is; the
/// rest is in the tables.
constexpr std::array<std::string_view, 14> drawn = {
    "none",
    "painter",
    "newell[split=off]",
    "newell[predicates=epsilon]",
    "zbuffer[depth=eye]",
    "zbuffer[depth=reversed32]",
    "zbuffer[depth=float32]",
    "zbuffer[depth=unorm24]",
    "zbuffer[depth=unorm16]",
    "zbuffer[snap=8]",
    "zbuffer-fast[exact=no]",
    "raycast[test=watertight]",
    "raycast[test=moller-trumbore]",
    "embree-robust",
};
/// Those that ask in float first, and those that ask in double.
constexpr std::array<std::string_view, 2> with_lanes = {"zbuffer-fast", "raycast-fast"};
constexpr std::array<std::string_view, 2> with_doubles = {"zbuffer", "raycast"};

/// Where k goes far beyond the breakdown points, they need the room.
report::Axis axis_of(const FamilyResult& family) {
  constexpr int far = 100;
  return {std::string(family.family->k_means), family.family->greatest > far};
}

report::Look look_of(std::size_t place) {
  return {static_cast<unsigned>(place % 7), static_cast<unsigned>(place % 14)};
}

std::optional<std::size_t> place_of(const StressResult& result, std::string_view name) {
  const auto found = std::ranges::find(result.modes, name, &Mode::name);
  if (found == result.modes.end()) return std::nullopt;
  return static_cast<std::size_t>(found - result.modes.begin());
}

std::vector<report::Point> failing_points(const FamilyResult& family, std::size_t mode) {
  std::vector<report::Point> points;
  for (const Trial& trial : family.trials) {
    const Outcome& outcome = trial.outcomes[mode];
    if (!outcome.not_run.empty()) continue;
    points.push_back({static_cast<double>(trial.k),
                      100.0 * static_cast<double>(outcome.failing()) / static_cast<double>(trial.pixels)});
  }
  return points;
}

bool same(const std::vector<report::Point>& p, const std::vector<report::Point>& q) {
  return std::ranges::equal(
      p, q, [](const report::Point& a, const report::Point& b) { return a.x == b.x && a.y == b.y; });
}

/// A name for the line of exact modes, and of all others that fail nowhere.
std::string name_of_right_ones(const StressResult& result, const FamilyResult& family) {
  std::size_t exact = 0;
  std::size_t others = 0;
  for (std::size_t mode = 0; mode < result.modes.size(); ++mode) {
    if (result.modes[mode].exact) {
      ++exact;
    } else if (!breakdown_point(family, mode)) {
      ++others;
    }
  }
  std::string name = counted(exact, "exact mode");
  if (others > 0) name += ", " + std::to_string(others) + " others";
  return name;
}

/// One line for all exact modes, and one for each of `drawn` that fails differently from those before it.
std::vector<report::Series> failing_lines(const StressResult& result, const FamilyResult& family) {
  std::vector<report::Series> lines;
  const auto exact = std::ranges::find_if(result.modes, &Mode::exact);
  if (exact != result.modes.end()) {
    const auto mode = static_cast<std::size_t>(exact - result.modes.begin());
    lines.push_back(
        {name_of_right_ones(result, family), {0, 13}, failing_points(family, mode), true, true, true});
  }
  for (std::size_t rank = 0; rank < drawn.size(); ++rank) {
    const auto mode = place_of(result, drawn[rank]);
    if (!mode) continue;
    std::vector<report::Point> points = failing_points(family, *mode);
    const auto alike =
        std::ranges::find_if(lines, [&](const report::Series& line) { return same(line.points, points); });
    if (alike == lines.end()) {
      lines.push_back({std::string(drawn[rank]), look_of(rank), std::move(points), true, true});
    }
  }
  return lines;
}

report::Series share_line(const FamilyResult& family, std::size_t mode, const std::string& name,
                          std::uint64_t Outcome::*part, report::Look look, bool dashed) {
  report::Series line = {name, look, {}, true, true, dashed};
  for (const Trial& trial : family.trials) {
    const Outcome& outcome = trial.outcomes[mode];
    if (outcome.questions == 0) continue;
    line.points.push_back({static_cast<double>(trial.k), 100.0 * static_cast<double>(outcome.*part) /
                                                             static_cast<double>(outcome.questions)});
  }
  return line;
}

std::vector<report::Series> share_lines(const StressResult& result, const FamilyResult& family) {
  std::vector<report::Series> lines;
  unsigned rank = 0;
  for (const std::string_view name : with_lanes) {
    const auto mode = place_of(result, name);
    if (!mode) continue;
    lines.push_back(share_line(family, *mode, std::string(name) + ": double", &Outcome::to_double,
                               {rank, 2 * rank}, true));
    lines.push_back(share_line(family, *mode, std::string(name) + ": exact", &Outcome::to_exact,
                               {rank, 2 * rank + 1}, false));
    ++rank;
  }
  for (const std::string_view name : with_doubles) {
    const auto mode = place_of(result, name);
    if (!mode) continue;
    lines.push_back(share_line(family, *mode, std::string(name) + ": exact", &Outcome::to_exact,
                               {rank, 2 * rank + 1}, false));
    ++rank;
  }
  std::erase_if(lines, [](const report::Series& line) { return line.points.empty(); });
  return lines;
}

}  // namespace

report::Plot failing_plot(const StressResult& result, const FamilyResult& family) {
  const std::string name(family.family->name);
  return {name,
          name + ": " + std::string(family.family->title),
          {{"", axis_of(family), {"failing pixels (% of the picture)", true}, failing_lines(result, family)}},
          1};
}

report::Plot exactness_plot(const StressResult& result, const FamilyResult& family) {
  const std::string name(family.family->name);
  return {name + "-exactness",
          name + ": what floats, and what doubles, could not settle",
          {{"", axis_of(family), {"per 100 questions", true}, share_lines(result, family)}},
          1};
}

}  // namespace hsr::stress
