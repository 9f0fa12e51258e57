#include "stress/stress_tables.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "text_layout.h"

namespace hsr::stress {
namespace {

constexpr const char* never = "-";

std::string point_text(const FamilyResult& family, std::size_t mode) {
  const std::optional<int> point = breakdown_point(family, mode);
  if (point) return std::to_string(*point);
  const bool tried = std::ranges::any_of(
      family.trials, [mode](const Trial& trial) { return trial.outcomes[mode].not_run.empty(); });
  return tried ? never : "?";
}

std::vector<std::string> points_of(const StressResult& result, std::size_t mode) {
  std::vector<std::string> points;
  for (const FamilyResult& family : result.families) points.push_back(point_text(family, mode));
  return points;
}

std::optional<std::size_t> place_of(const StressResult& result, std::string_view name) {
  const auto found = std::ranges::find(result.modes, name, &Mode::name);
  if (found == result.modes.end()) return std::nullopt;
  return static_cast<std::size_t>(found - result.modes.begin());
}

/// The greatest share over a family's trials of what `part` tells, in per cent.
std::string greatest_share(const FamilyResult& family, std::size_t mode, std::uint64_t Outcome::*part) {
  double greatest = 0.0;
  bool any = false;
  for (const Trial& trial : family.trials) {
    const Outcome& outcome = trial.outcomes[mode];
    if (outcome.questions == 0) continue;
    any = true;
    greatest =
        std::max(greatest, static_cast<double>(outcome.*part) / static_cast<double>(outcome.questions));
  }
  return any ? significant(100.0 * greatest, 3) + " %" : "";
}

/// The greatest ratio of times over a family's trials.
std::string greatest_ratio(const FamilyResult& family, std::size_t slow, std::size_t fast) {
  double greatest = 0.0;
  for (const Trial& trial : family.trials) {
    const double base = trial.outcomes[fast].ms;
    if (base > 0.0) greatest = std::max(greatest, trial.outcomes[slow].ms / base);
  }
  return greatest > 0.0 ? significant(greatest, 3) : "";
}

/// An exact mode, and the same without exactness.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> with_and_without = {{
    {"zbuffer-fast", "zbuffer-fast[exact=no]"},
    {"raycast-fast", ""},
    {"zbuffer", "zbuffer[depth=eye]"},
    {"raycast", "raycast[test=watertight]"},
    {"newell", "newell[predicates=epsilon]"},
}};

std::string text_of(const report::Table& table) {
  TextTable text(table.heading);
  for (const auto& row : table.rows) text.add_row(row);
  return text.text();
}

/// What becomes harder, and what was tried.
std::string family_words(const FamilyResult& family) {
  std::string text(family.family->title);
  if (family.trials.empty()) return text;
  text +=
      "; k = " + std::to_string(family.trials.front().k) + " to " + std::to_string(family.trials.back().k);
  if (family.family->differs_to < family.family->greatest) {
    text += ", float32 tells to " + std::to_string(family.family->differs_to);
  }
  return text;
}

/// A name that a terminal has room for: the first ones of a group, and how many more there are.
std::string short_name(const StressResult& result, const ModeGroup& group) {
  constexpr std::size_t room = 44;
  if (group.exact && group.modes.size() > 1) return group.name;
  std::string text = result.modes[group.modes.front()].name;
  std::size_t named = 1;
  for (; named < group.modes.size(); ++named) {
    const std::string longer = text + ", " + result.modes[group.modes[named]].name;
    if (longer.size() > room) break;
    text = longer;
  }
  const std::size_t more = group.modes.size() - named;
  return more == 0 ? text : text + " and " + std::to_string(more) + " more";
}

}  // namespace

std::vector<ModeGroup> groups_of(const StressResult& result) {
  std::vector<ModeGroup> groups;
  std::vector<std::vector<std::string>> points_of_group;
  for (std::size_t mode = 0; mode < result.modes.size(); ++mode) {
    const std::vector<std::string> points = points_of(result, mode);
    const bool exact = result.modes[mode].exact;
    const auto same = [&](std::size_t group) {
      return groups[group].exact == exact && points_of_group[group] == points;
    };
    std::size_t place = 0;
    while (place < groups.size() && !same(place)) ++place;
    if (place == groups.size()) {
      groups.push_back({result.modes[mode].name, {}, exact});
      points_of_group.push_back(points);
    } else if (!exact) {
      groups[place].name += ", " + result.modes[mode].name;
    }
    groups[place].modes.push_back(mode);
  }
  for (ModeGroup& group : groups) {
    if (group.exact && group.modes.size() > 1) group.name = counted(group.modes.size(), "exact mode");
  }
  std::ranges::stable_partition(groups, [](const ModeGroup& group) { return group.exact; });
  return groups;
}

report::Table breakdown_table(const StressResult& result) {
  report::Table table = {{"least k with a wrong pixel"}, {}};
  for (const FamilyResult& family : result.families) table.heading.emplace_back(family.family->name);
  for (const ModeGroup& group : groups_of(result)) {
    std::vector<std::string> row = {group.name};
    for (std::string& point : points_of(result, group.modes.front())) row.push_back(std::move(point));
    table.rows.push_back(std::move(row));
  }
  return table;
}

report::Table exactness_table(const StressResult& result) {
  report::Table table = {{"share of questions, most at any k"}, {}};
  for (const auto& [exact, inexact] : with_and_without) {
    const auto mode = place_of(result, exact);
    if (!mode) continue;
    const std::string name(exact);
    if (name.ends_with("-fast")) table.heading.push_back(name + " to double");
    table.heading.push_back(name + " to exact");
    if (place_of(result, inexact)) table.heading.push_back(name + " time / inexact");
  }
  for (const FamilyResult& family : result.families) {
    std::vector<std::string> row = {std::string(family.family->name)};
    for (const auto& [exact, inexact] : with_and_without) {
      const auto mode = place_of(result, exact);
      if (!mode) continue;
      if (exact.ends_with("-fast")) row.push_back(greatest_share(family, *mode, &Outcome::to_double));
      row.push_back(greatest_share(family, *mode, &Outcome::to_exact));
      if (const auto other = place_of(result, inexact)) row.push_back(greatest_ratio(family, *mode, *other));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

report::Table family_table(const StressResult& result) {
  report::Table table = {{"family", "what becomes harder", "k tried", "float32 tells to k"}, {}};
  for (const FamilyResult& family : result.families) {
    if (family.trials.empty()) continue;
    table.rows.push_back(
        {std::string(family.family->name), std::string(family.family->title),
         std::to_string(family.trials.front().k) + " to " + std::to_string(family.trials.back().k),
         std::to_string(family.family->differs_to)});
  }
  return table;
}

report::Table trial_table(const StressResult& result) {
  report::Table table = {
      {"family", "k", "algorithm", "exact", "triangles", "pixels", "covered", "wrong", "holes", "leaks",
       "list_errors", "questions", "to_double", "to_exact", "ms", "not_run"},
      {}};
  for (const FamilyResult& family : result.families) {
    for (const Trial& trial : family.trials) {
      for (std::size_t mode = 0; mode < result.modes.size(); ++mode) {
        const Outcome& outcome = trial.outcomes[mode];
        const auto number = [](std::uint64_t value) { return std::to_string(value); };
        table.rows.push_back(
            {std::string(family.family->name), std::to_string(trial.k), result.modes[mode].name,
             result.modes[mode].exact ? "yes" : "no", number(trial.triangles), number(trial.pixels),
             number(trial.covered), number(outcome.wrong), number(outcome.holes), number(outcome.leaks),
             number(outcome.list_errors), number(outcome.questions), number(outcome.to_double),
             number(outcome.to_exact), significant(outcome.ms, 4), outcome.not_run});
      }
    }
  }
  return table;
}

std::string to_text(const StressResult& result) {
  constexpr std::size_t families_per_table = 5;
  std::string text;
  for (const FamilyResult& family : result.families) {
    text += definition(family.family->name, family_words(family), 0, 14);
  }
  text += "\n" +
          paragraph(
              "Breakdown points: the least k that was tried at which a pixel is wrong; - "
              "where none is, ? where nothing was tried.") +
          "\n";
  for (std::size_t first = 0; first < result.families.size(); first += families_per_table) {
    const std::size_t last = std::min(first + families_per_table, result.families.size());
    const StressResult part = {result.modes,
                               {result.families.begin() + static_cast<std::ptrdiff_t>(first),
                                result.families.begin() + static_cast<std::ptrdiff_t>(last)}};
    report::Table table = breakdown_table(part);
    const std::vector<ModeGroup> groups = groups_of(part);
    for (std::size_t row = 0; row < groups.size(); ++row) table.rows[row][0] = short_name(part, groups[row]);
    text += text_of(table) + "\n";
  }
  const std::vector<std::string> broken = broken_promises(result);
  for (const std::string& promise : broken) text += paragraph("Broken promise: " + promise);
  if (broken.empty()) text += "No exact mode is wrong at any pixel or in any list.\n";
  return text;
}

}  // namespace hsr::stress
