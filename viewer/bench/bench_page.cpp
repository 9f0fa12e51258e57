#include "bench/bench_page.h"

#include <algorithm>
#include <string_view>

#include "bench/bench_plots.h"
#include "report/page.h"
#include "scene/atomic_file.h"
#include "text_layout.h"

namespace hsr::bench {
namespace {

using report::Table;

void write_whole(const std::filesystem::path& file, const std::string& text) {
  write_file_atomically(file, [&](const std::filesystem::path& temporary) { write_bytes(temporary, text); });
}

std::string error_text(const RunRecord& run) {
  return run.wrong_pixels() == 0 ? "no wrong pixel"
                                 : significant(*run.errors_per_million(), 3) + " wrong per million";
}

/// "teapot, 640x360, 1 thread: zbuffer-fast[exact=no] 1.2 ms, 3.1 wrong per million; then ..."
std::string front_sentence(const Tradeoff& tradeoff) {
  std::string text =
      tradeoff.scene + ", " + std::to_string(tradeoff.width) + "x" + std::to_string(tradeoff.height) + ": ";
  for (std::size_t k = 0; k < tradeoff.front.size(); ++k) {
    const RunRecord& run = *tradeoff.front[k];
    text += (k == 0 ? "" : "; then ") + run.name + ", " + milliseconds(run.render.median()) + ", " +
            error_text(run);
  }
  return text + ".";
}

std::string peer_sentence(const Tradeoff& tradeoff) {
  std::string text;
  for (const RunRecord* run : tradeoff.runs) {
    if (!run->peer) continue;
    text += (text.empty() ? "Other programs: " : "; ") + run->name + ", " +
            milliseconds(run->render.median()) + ", " + error_text(*run);
    if (run->errors->depth) text += ", depth off by " + significant(run->errors->depth->max, 2);
  }
  return text.empty() ? text : text + ".";
}

std::string spread_text(const RunRecord& run) {
  return three_digits(run.render.at(0.25)) + " to " + three_digits(run.render.at(0.75)) +
         (run.settled ? "" : " *");
}

std::string optional_text(bool there, double value) { return there ? significant(value, 3) : ""; }

Table tradeoff_table(const std::vector<RunRecord>& runs, const Tradeoff& tradeoff) {
  Table table = {{"algorithm", "threads", "without", "least ms", "median", "middle half", "prepare", "MB",
                  "wrong", "holes", "leaks", "per million", "depth error", "color rmse", "missing", "extra",
                  "inversions", "failed"},
                 {}};
  for (const RunRecord& run : runs) {
    if (run.question != Question::tradeoff || run.scene != tradeoff.scene || run.width != tradeoff.width ||
        run.height != tradeoff.height)
      continue;
    std::vector<std::string> row = {run.name, std::to_string(run.threads), run.skip_off};
    if (run.failed.empty() && run.errors) {
      const exact::Errors& errors = *run.errors;
      constexpr double megabyte = 1e6;
      row.insert(row.end(),
                 {three_digits(run.render.least()), three_digits(run.render.median()), spread_text(run),
                  three_digits(run.prepare_ms),
                  run.peer ? "" : three_digits(static_cast<double>(run.bytes) / megabyte),
                  grouped(errors.wrong), grouped(errors.holes), grouped(errors.leaks),
                  significant(run.errors_per_million().value_or(0.0), 3),
                  errors.depth ? significant(errors.depth->max, 2) : "",
                  errors.color ? significant(errors.color->rmse, 2) : "",
                  run.lists ? grouped(run.lists->missing) : "", run.lists ? grouped(run.lists->extra) : "",
                  run.lists ? grouped(run.lists->inversions) : ""});
    }
    row.resize(table.heading.size());
    row.back() = run.failed;
    table.rows.push_back(row);
  }
  return table;
}

Table growth_table(const std::vector<RunRecord>& runs, Question question) {
  Table table = {{"algorithm", "exponent", "standard error", "largest", "its median ms"}, {}};
  for (const Growth& growth : growths(runs, question)) {
    const RunRecord& last = *growth.runs.back();
    table.rows.push_back(
        {growth.name, optional_text(growth.law.has_value(), growth.law ? growth.law->exponent : 0),
         optional_text(growth.law.has_value(), growth.law ? growth.law->error : 0),
         grouped(static_cast<std::uint64_t>(last.parameter)), three_digits(last.render.median())});
  }
  std::vector<std::string_view> told;
  for (const RunRecord& run : runs) {
    if (run.question != question || run.failed.empty() || std::ranges::find(told, run.name) != told.end())
      continue;
    told.push_back(run.name);
    table.rows.push_back(
        {run.name, run.failed, "", grouped(static_cast<std::uint64_t>(run.parameter)) + " and more", ""});
  }
  return table;
}

Table skip_table(const std::vector<RunRecord>& runs) {
  Table table = {{"algorithm", "without", "scene", "times as long", "middle half", "skipped with it"}, {}};
  for (const SkipGain& gain : skip_gains(runs)) {
    const auto skipped = gain.with->skipped.find(gain.without->skip_off);
    table.rows.push_back({gain.with->name, gain.without->skip_off, gain.with->scene,
                          significant(gain.times, 3),
                          significant(gain.low, 3) + " to " + significant(gain.high, 3),
                          skipped == gain.with->skipped.end() ? "" : grouped(skipped->second)});
  }
  return table;
}

Table thread_table(const std::vector<RunRecord>& runs) {
  Table table = {{"algorithm", "scene", "threads", "median ms", "times as fast as on fewest"}, {}};
  for (const RunRecord& run : runs) {
    if (run.question != Question::tradeoff || !run.skip_off.empty() || run.render.ms.empty()) continue;
    const auto fewest = std::ranges::find_if(runs, [&](const RunRecord& other) {
      return other.question == run.question && other.scene == run.scene && other.width == run.width &&
             other.height == run.height && other.name == run.name && other.skip_off.empty() &&
             other.threads < run.threads && !other.render.ms.empty();
    });
    if (fewest == runs.end()) continue;
    table.rows.push_back({run.name, run.scene, std::to_string(run.threads), three_digits(run.render.median()),
                          significant(fewest->render.median() / run.render.median(), 3)});
  }
  return table;
}

Table structure_table(const std::vector<RunRecord>& runs) {
  Table table = {{"structure", "scene", "triangles", "build ms", "MB", "trace ms"}, {}};
  for (const RunRecord* run : structure_runs(runs))
    table.rows.push_back({run->name, run->scene, grouped(run->triangles), three_digits(run->prepare_ms),
                          three_digits(static_cast<double>(run->bytes) / 1e6),
                          three_digits(run->render.median())});
  return table;
}

constexpr const char* of_1974 =
    "Sutherland, Sproull and Schumacker (A characterization of ten hidden-surface algorithms, 1974) compared "
    "methods by the number of their operations. Here the textbook versions are counted, step by step, so "
    "that "
    "the counts are the same on every machine. The scene: triangles in four wavy sheets that fill a picture "
    "of "
    "512x512 and lie one behind the other, in no order in the file; the more triangles, the smaller. An "
    "operation on faces is a comparison of two sort keys, one test of a pair, an exchange or a cut; one on "
    "pixels is a fragment painted, compared, stored or sorted, or a box or triangle that a ray is tested "
    "against. Relative is to depth sort with the fewest faces. Their own figures are not repeated here, as "
    "no "
    "copy of them could be checked.";

/// Text as a table of the terminal.
std::string terminal_table(const Table& table) {
  TextTable text(table.heading);
  for (const std::vector<std::string>& row : table.rows) text.add_row(row);
  return text.text();
}

/// Draws the plots as it adds them to the page.
class Writer {
 public:
  Writer(std::filesystem::path folder) : folder_(std::move(folder)), page_("Run time against error") {}

  report::Page& page() { return page_; }
  void plot(const DescribedPlot& plot) {
    if (plot.plot.panels.empty()) return;
    const report::PlotFiles files = report::write_plot(plot.plot, folder_);
    drawn_ = drawn_ && !files.svg.empty() && !files.png.empty();
    page_.plot(files, plot.says);
  }
  bool finish() {
    page_.write(folder_ / "index.html");
    return drawn_;
  }

 private:
  std::filesystem::path folder_;
  report::Page page_;
  bool drawn_ = true;
};

void add_how(const BenchReport& report, report::Page& page) {
  page.chapter("How it was measured");
  page.paragraph(report.repeats);
  page.paragraph(
      "The time is that of one picture with everything prepared that no camera changes; preparing and "
      "loading "
      "stand apart in the tables. Fast versions and other programs make ids and depths, textbook versions "
      "colours as well. A star marks times whose spread is not known, or is not as small as wanted. Errors "
      "are counted against the exact answer; a wrong pixel shows a triangle that is not one of the nearest, "
      "a hole shows background, a leak shows something where nothing is.");
  Table machine = {{"", ""}, {}};
  for (const auto& [name, value] : report.machine) machine.rows.push_back({name, value});
  page.table(machine);
}

}  // namespace

std::string to_text(const BenchReport& report) {
  std::string text;
  for (const Tradeoff& tradeoff : tradeoffs(report.runs)) {
    text += paragraph(front_sentence(tradeoff));
    if (const std::string peers = peer_sentence(tradeoff); !peers.empty()) text += paragraph(peers);
    text += "\n";
  }
  for (const Question question : {Question::triangles, Question::pixels, Question::depth}) {
    const Table table = growth_table(report.runs, question);
    if (!table.rows.empty())
      text += "Growth with " + std::string(name_of(question)) + "\n\n" + terminal_table(table) + "\n";
  }
  if (!report.costs.empty()) text += "The table of 1974\n\n" + terminal_table(to_table(report.costs)) + "\n";
  return text;
}

bool write_report(const BenchReport& report, const std::filesystem::path& folder) {
  write_whole(folder / "bench.json", to_json(report));
  write_whole(folder / "bench.csv", to_csv(to_table(report.runs)));
  Writer writer(folder);
  report::Page& page = writer.page();
  for (const Tradeoff& tradeoff : tradeoffs(report.runs)) {
    page.chapter("Time against error: " + tradeoff.scene + ", " + std::to_string(tradeoff.width) + "x" +
                 std::to_string(tradeoff.height));
    page.paragraph("Not beaten in both time and error: " + front_sentence(tradeoff));
    if (const std::string peers = peer_sentence(tradeoff); !peers.empty()) page.paragraph(peers);
    writer.plot(tradeoff_plot(tradeoff));
    page.folded_table("All figures", tradeoff_table(report.runs, tradeoff));
  }
  for (const Question question : {Question::triangles, Question::pixels, Question::depth}) {
    const Table table = growth_table(report.runs, question);
    if (table.rows.empty()) continue;
    page.chapter("Growth with " + std::string(name_of(question)));
    page.paragraph(
        "The scene is sheets, wavy sheets of triangles that fill the picture one behind the other: "
        "covered area and depth complexity stay the same whatever the number of triangles. The "
        "exponent is fitted to the upper end of the range, the last two decades where there are "
        "as many.");
    writer.plot(growth_plot(report.runs, question));
    page.table(table);
  }
  const auto section = [&](const char* title, const DescribedPlot& plot, const Table& table) {
    if (table.rows.empty()) return;
    page.chapter(title);
    writer.plot(plot);
    page.folded_table("All figures", table);
  };
  section("What each skip saves", skip_plot(report.runs), skip_table(report.runs));
  section("Structures of ray casting", structure_plot(report.runs), structure_table(report.runs));
  section("Threads", {}, thread_table(report.runs));
  if (!report.costs.empty()) {
    page.chapter("The table of 1974");
    page.paragraph(of_1974);
    writer.plot(plot_of_1974(report.costs));
    page.table(to_table(report.costs));
  }
  add_how(report, page);
  return writer.finish();
}

}  // namespace hsr::bench
