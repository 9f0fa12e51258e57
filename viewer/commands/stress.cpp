#include <algorithm>
#include <ostream>

#include "commands/commands.h"
#include "nearest_name.h"
#include "output_file.h"
#include "progress_bar.h"
#include "report/journal.h"
#include "report/machine.h"
#include "scene/atomic_file.h"
#include "scene/errors.h"
#include "stress/refusals.h"
#include "stress/stress.h"
#include "stress/stress_json.h"
#include "stress/stress_report.h"
#include "stress/stress_tables.h"
#include "text_layout.h"

namespace hsr {
namespace {

std::vector<const stress::Family*> chosen_families(const std::vector<std::string>& names) {
  std::vector<const stress::Family*> chosen;
  std::vector<std::string_view> known;
  for (const stress::Family& family : stress::families()) {
    known.push_back(family.name);
    if (names.empty() || std::ranges::find(names, family.name) != names.end()) chosen.push_back(&family);
  }
  for (const std::string& name : names) {
    if (std::ranges::find(known, name) == known.end()) {
      throw UsageError("unknown family \"" + name + "\"" + what_there_is(name, known));
    }
  }
  return chosen;
}

stress::StressPlan plan_of(const StressCommand& command) {
  stress::StressPlan plan;
  plan.families = chosen_families(command.families);
  plan.quick = command.quick;
  plan.threads = command.threads;
  plan.modes = command.algorithms.empty() ? stress::catalogue_modes() : stress::modes_of(command.algorithms);
  if (command.peers && command.algorithms.empty()) {
    for (stress::Mode& peer : stress::peer_modes()) plan.modes.push_back(std::move(peer));
  }
  return plan;
}

/// What a run is: trials of another one cannot be taken over.
std::string identity(const stress::StressPlan& plan, const report::Machine& machine) {
  std::string text = plan.quick ? "stress, quick" : "stress";
  for (const auto& [name, value] : machine.rows()) text += " | " + value;
  for (const stress::Mode& mode : plan.modes) text += " | " + mode.name;
  return text;
}

stress::TrialStore store_in(report::Journal& journal, const std::vector<stress::Mode>& modes) {
  const auto key = [](const stress::Family& family, int k) {
    return std::string(family.name) + " " + std::to_string(k);
  };
  return {[&journal, &modes, key](const stress::Family& family, int k) -> std::optional<stress::Trial> {
            const std::optional<std::string> json = journal.find(key(family, k));
            if (!json) return std::nullopt;
            return stress::trial_of_json(*json, modes);
          },
          [&journal, key](const stress::Family& family, const stress::Trial& trial) {
            journal.add(key(family, trial.k), stress::to_json(trial));
          }};
}

void tell_refusals(const std::vector<stress::Refusal>& refusals, std::ostream& out) {
  const auto taken = static_cast<std::size_t>(
      std::ranges::count_if(refusals, [](const stress::Refusal& refusal) { return !refusal.refused(); }));
  if (taken == 0) {
    out << "All " << refusals.size() << " scenes and cameras with NaN, infinity and the like are refused.\n";
  }
  for (const stress::Refusal& refusal : refusals) {
    if (!refusal.refused()) out << paragraph("Not refused: " + refusal.what);
  }
}

}  // namespace

void run(const StressCommand& command, std::ostream& out) {
  const stress::StressPlan plan = plan_of(command);
  const report::Machine machine = report::this_machine();
  ProgressBar bar;
  stress::StressResult result;
  if (command.folder) {
    make_folder(*command.folder);
    report::Journal journal(*command.folder / "stress.journal", identity(plan, machine));
    if (journal.taken_over() > 0) {
      out << "Goes on with " << counted(journal.taken_over(), "trial") << " of an earlier run." << std::endl;
    }
    result = stress::run_stress(plan, bar.listener(), store_in(journal, plan.modes));
    bar.erase();
    const std::vector<stress::Refusal> refusals = stress::try_refusals();
    out << stress::to_text(result);
    tell_refusals(refusals, out);
    stress::write_report(result, refusals, machine, *command.folder);
    journal.finish();
    out << "Wrote " << (*command.folder / "stress.html").string() << " and what it shows.\n";
    return;
  }
  const stress::TrialStore nothing = {[](const auto&, int) { return std::nullopt; },
                                      [](const auto&, const auto&) {}};
  result = stress::run_stress(plan, bar.listener(), nothing);
  bar.erase();
  out << stress::to_text(result);
  tell_refusals(stress::try_refusals(), out);
}

}  // namespace hsr
