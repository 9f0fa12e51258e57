#include "stress/stress_report.h"

#include <string>

#include "report/page.h"
#include "scene/atomic_file.h"
#include "stress/stress_json.h"
#include "stress/stress_plots.h"
#include "stress/stress_tables.h"
#include "text_layout.h"

namespace hsr::stress {
namespace {

void write_text(const std::filesystem::path& file, const std::string& text) {
  write_file_atomically(file, [&](const auto& temporary) { write_bytes(temporary, text); });
}

report::Table refusal_table(const std::vector<Refusal>& refusals) {
  report::Table table = {{"input", "what was said"}, {}};
  for (const Refusal& refusal : refusals) {
    table.rows.push_back({refusal.what, refusal.refused() ? refusal.said : "taken, which is wrong"});
  }
  return table;
}

report::Table machine_table(const report::Machine& machine) {
  report::Table table = {{"", ""}, {}};
  for (const auto& [name, value] : machine.rows()) table.rows.push_back({name, value});
  return table;
}

/// The trials of one family with the figures of all groups.
report::Table failing_table(const StressResult& result, const FamilyResult& family) {
  report::Table table = {{"algorithm"}, {}};
  for (const Trial& trial : family.trials) table.heading.push_back("k = " + std::to_string(trial.k));
  for (std::size_t mode = 0; mode < result.modes.size(); ++mode) {
    std::vector<std::string> row = {result.modes[mode].name};
    for (const Trial& trial : family.trials) {
      const Outcome& outcome = trial.outcomes[mode];
      row.push_back(outcome.not_run.empty() ? grouped(outcome.failing()) : "?");
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

void add_family(const StressResult& result, const FamilyResult& family, const std::filesystem::path& folder,
                report::Page& page) {
  const std::string name(family.family->name);
  page.chapter(name + ": " + std::string(family.family->title));
  page.paragraph(std::string(family.family->k_means) + ". float32 positions hold the difficulty up to k = " +
                 std::to_string(family.family->differs_to) + " (" + std::string(family.family->evidence) +
                 ").");
  page.plot(report::write_plot(failing_plot(result, family), folder),
            "Failing pixels over k, a line for each algorithm and setting that fails in a way of its own.");
  const report::Plot exactness = exactness_plot(result, family);
  if (!exactness.panels.front().series.empty()) {
    page.plot(report::write_plot(exactness, folder),
              "How many questions out of 100 exact modes settled in double and in exact arithmetic, over k.");
  }
  page.folded_table("Failing pixels of every algorithm and setting", failing_table(result, family));
}

}  // namespace

void write_report(const StressResult& result, const std::vector<Refusal>& refusals,
                  const report::Machine& machine, const std::filesystem::path& folder) {
  write_text(folder / "stress.json", to_json(result, machine));
  write_text(folder / "breakdown.csv", report::to_csv(breakdown_table(result)));
  write_text(folder / "exactness.csv", report::to_csv(exactness_table(result)));
  write_text(folder / "trials.csv", report::to_csv(trial_table(result)));

  report::Page page("Where each algorithm breaks");
  page.chapter("Breakdown points");
  page.paragraph(
      "Scenes that become harder as a whole number k grows, put to every algorithm and setting. The "
      "breakdown "
      "point is the least k that was tried at which a pixel shows what is not nearest there, shows nothing, "
      "or "
      "shows something where nothing is, against the exact answer; - where there is none.");
  page.table(breakdown_table(result));
  for (const std::string& broken : broken_promises(result)) page.paragraph("Broken promise: " + broken);
  page.chapter("The families");
  page.table(family_table(result));
  page.chapter("What exactness takes");
  page.paragraph(
      "A question is whether a triangle covers a pixel's centre, or is nearer there. The fast versions ask "
      "in "
      "float first, the others in double. Times are those of the exact mode over the same without exactness, "
      "the greatest at any k.");
  page.table(exactness_table(result));
  page.chapter("NaN, infinity, and cameras that are none");
  page.table(refusal_table(refusals));
  for (const FamilyResult& family : result.families) add_family(result, family, folder, page);
  page.chapter("The machine");
  page.table(machine_table(machine));
  page.write(folder / "stress.html");
}

}  // namespace hsr::stress
