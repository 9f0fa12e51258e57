#include "bench/baseline.h"

#include <algorithm>
#include <map>

#include "text_layout.h"

namespace hsr::bench {
namespace {

constexpr double least_change = 1.1;

/// One measure of two runs; less is better.
struct Measure {
  const char* name;
  double before;
  double after;
};

std::vector<Measure> measures(const RunRecord& before, const RunRecord& after) {
  std::vector<Measure> all;
  const auto count = [&](const char* name, std::uint64_t a, std::uint64_t b) {
    all.push_back({name, static_cast<double>(a), static_cast<double>(b)});
  };
  if (before.errors && after.errors) {
    const exact::Errors& a = *before.errors;
    const exact::Errors& b = *after.errors;
    count("wrong", a.wrong, b.wrong);
    count("holes", a.holes, b.holes);
    count("leaks", a.leaks, b.leaks);
    if (a.depth && b.depth) {
      all.push_back({"depth error", a.depth->max, b.depth->max});
      all.push_back({"depth error of 99 in 100", a.depth->p99, b.depth->p99});
    }
    if (a.color && b.color) {
      all.push_back({"color rmse", a.color->rmse, b.color->rmse});
      all.push_back({"color error", a.color->max, b.color->max});
    }
  }
  if (before.lists && after.lists) {
    count("missing", before.lists->missing, after.lists->missing);
    count("extra", before.lists->extra, after.lists->extra);
    count("inversions", before.lists->inversions, after.lists->inversions);
  }
  return all;
}

void compare_errors(Change& change) {
  // What a JSON file rounds off is not an error.
  constexpr double rounding = 1e-12;
  for (const Measure& measure : measures(*change.before, *change.after)) {
    const std::string text = std::string(measure.name) + " " + report::number_text(measure.before) + " -> " +
                             report::number_text(measure.after);
    if (measure.after > measure.before * (1.0 + rounding))
      change.more_wrong += (change.more_wrong.empty() ? "" : ", ") + text;
    else if (measure.after < measure.before * (1.0 - rounding))
      change.less_wrong += (change.less_wrong.empty() ? "" : ", ") + text;
  }
}

void compare_times(double drift, Change& change) {
  const Timing& before = change.before->render;
  const Timing& after = change.after->render;
  if (before.ms.empty() || after.ms.empty()) return;
  change.times = after.median() / (before.median() * drift);
  change.slower = change.times > least_change && after.at(0.25) > drift * before.at(0.75);
  change.faster = change.times < 1.0 / least_change && after.at(0.75) < drift * before.at(0.25);
}

/// Which rows decide whether times may be compared.
std::string machine_text(const BenchReport& report) {
  std::string text;
  for (const auto& [name, value] : report.machine) {
    if (name == "processor" || name == "cores" || name == "build") text += name + " " + value + "; ";
  }
  return text;
}

double drift_of(const std::vector<Change>& pairs) {
  Timing ratios;
  for (const Change& pair : pairs) {
    if (pair.before->peer && !pair.before->render.ms.empty() && !pair.after->render.ms.empty())
      ratios.ms.push_back(pair.after->render.median() / pair.before->render.median());
  }
  return ratios.ms.empty() ? 1.0 : ratios.median();
}

}  // namespace

bool Baseline::worse() const {
  return gone > 0 || std::ranges::any_of(changes, [](const Change& change) {
           return change.slower || !change.more_wrong.empty();
         });
}

Baseline compare_reports(const BenchReport& before, const BenchReport& after) {
  Baseline baseline;
  std::map<std::string, const RunRecord*> by_key;
  for (const RunRecord& run : after.runs) {
    if (run.failed.empty()) by_key[run.key()] = &run;
  }
  std::vector<Change> pairs;
  for (const RunRecord& run : before.runs) {
    if (!run.failed.empty()) continue;
    const auto found = by_key.find(run.key());
    if (found == by_key.end())
      ++baseline.gone;
    else
      pairs.push_back({&run, found->second});
  }
  baseline.compared = pairs.size();
  baseline.same_machine = machine_text(before) == machine_text(after);
  baseline.drift = drift_of(pairs);
  for (Change& pair : pairs) {
    if (pair.before->peer) continue;
    if (baseline.same_machine) compare_times(baseline.drift, pair);
    compare_errors(pair);
    if (pair.slower || pair.faster || !pair.more_wrong.empty() || !pair.less_wrong.empty())
      baseline.changes.push_back(pair);
  }
  std::ranges::stable_sort(baseline.changes, std::greater(), &Change::times);
  return baseline;
}

std::string to_text(const Baseline& baseline) {
  std::string text = counted(baseline.compared, "run") + " in both reports, " + grouped(baseline.gone) +
                     " of the old one without a counterpart.\n";
  if (!baseline.same_machine)
    text += paragraph("The machine or the build is not the same, so times are not compared.");
  if (baseline.drift != 1.0)
    text += paragraph("Other programs take " + significant(baseline.drift, 3) +
                      " times as long as then, so the machine does; times are compared after that.");
  const auto list = [&](const char* title, const auto& says) {
    std::string lines;
    for (const Change& change : baseline.changes) {
      if (const std::string what = says(change); !what.empty())
        lines += "  " + change.after->key() + ": " + what + "\n";
    }
    text += lines.empty() ? "" : std::string(title) + "\n" + lines;
  };
  const auto times = [](const Change& change) {
    return significant(change.times, 3) + " times as long (" + milliseconds(change.before->render.median()) +
           " -> " + milliseconds(change.after->render.median()) + ")";
  };
  list("More wrong:", [](const Change& change) { return change.more_wrong; });
  list("Slower:", [&](const Change& change) { return change.slower ? times(change) : ""; });
  list("Less wrong:", [](const Change& change) { return change.less_wrong; });
  list("Faster:", [&](const Change& change) { return change.faster ? times(change) : ""; });
  if (baseline.changes.empty()) text += "Nothing else changed beyond noise.\n";
  return text;
}

}  // namespace hsr::bench
