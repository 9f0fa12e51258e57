#include "bench/bench_command.h"

#include <optional>
#include <ostream>

#include "bench/baseline.h"
#include "bench/bench_page.h"
#include "bench/bench_run.h"
#include "output_file.h"
#include "progress_bar.h"
#include "scene/errors.h"
#include "text_file.h"
#include "text_layout.h"

namespace hsr::bench {
namespace {

BenchReport read_report(const std::filesystem::path& file) {
  constexpr std::size_t most_bytes = 500'000'000;
  try {
    return report_from_json(read_text_file(file, most_bytes));
  } catch (const InputError& error) {
    const std::string what = error.what();
    throw InputError(what.starts_with(file.string()) ? what : file.string() + ": " + what);
  }
}

}  // namespace

void run_bench(const BenchCommand& command, std::ostream& out) {
  const BenchPlan plan = make_plan(command);
  std::optional<report::Journal> journal;
  if (command.folder) {
    make_folder(*command.folder);
    journal.emplace(*command.folder / "runs.jsonl", identity(command));
    if (journal->taken_over() > 0)
      out << paragraph("An earlier run was stopped: " + counted(journal->taken_over(), "scene") +
                       " of it need not be run again.")
          << std::flush;
  }
  ProgressBar bar;
  const BenchReport report = run_plan(plan, journal ? &*journal : nullptr, bar.listener());
  bar.erase();
  out << to_text(report);
  if (!command.folder) return;
  const bool drawn = write_report(report, *command.folder);
  journal->finish();
  if (!drawn)
    out << paragraph(
        "Plots were left out, as gnuplot is not installed or could not draw; their data and scripts are "
        "there.");
  out << "Wrote " << (*command.folder / "index.html").string() << ", bench.json and bench.csv.\n";
}

void run_comparison(const BenchCommand& command, std::ostream& out) {
  const BenchReport before = read_report(command.compare->first);
  const BenchReport after = read_report(command.compare->second);
  const Baseline baseline = compare_reports(before, after);
  out << to_text(baseline) << std::flush;
  if (baseline.worse()) throw InputError("something became slower or more wrong, or is gone");
}

}  // namespace hsr::bench
