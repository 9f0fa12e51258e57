#include <doctest/doctest.h>

#include <fstream>
#include <limits>
#include <string>

#include "report/journal.h"
#include "report/machine.h"
#include "report/page.h"
#include "report/plot.h"
#include "report/plot_scale.h"
#include "report/table.h"
#include "support/temporary_folder.h"
#include "text_file.h"

namespace hsr::report {
namespace {

Plot small_plot() {
  Plot plot;
  plot.name = "it's-small";
  plot.title = "Time and error";
  Panel panel = {"teapot", {"time (ms)", true}, {"wrong pixels", true}, {}};
  panel.series.push_back(
      {"painter", {0, 0}, {{1.0, 0.0, {}, {}, "never wrong"}, {10.0, 100.0, Spread{9.0, 12.0}, {}}}});
  panel.series.push_back({"nowhere", {1, 1}, {{std::numeric_limits<double>::quiet_NaN(), 1.0}}});
  plot.panels.push_back(panel);
  return plot;
}

}  // namespace

TEST_CASE("report: 0 stands below everything else on a logarithmic axis, at a tick of its own") {
  const Scale scale = scale_of({"errors", true}, {0.0, 3.0, 2000.0});
  CHECK(scale.place(0.0) > scale.low);
  CHECK(scale.place(0.0) < 1.0);
  CHECK(scale.place(3.0) == 3.0);
  CHECK(scale.ticks.back().second == "0");
  CHECK_FALSE(scale.takes(-1.0));
  CHECK_FALSE(scale_of({"errors", true}, {3.0}).takes(0.0));
}

TEST_CASE("report: a linear axis has a few round ticks and shows every value") {
  const Scale scale = scale_of({"time (ms)"}, {3.0, 41.0});
  CHECK(scale.share(41.0) < 1.0);
  CHECK(scale.share(0.0) == 0.0);
  REQUIRE(scale.ticks.size() == 5);
  CHECK(scale.ticks[1].second == "10");
}

TEST_CASE("report: data of a plot leave out what no axis can show, and keep a block for every series") {
  const std::string data = plot_data(small_plot());
  CHECK(data.find("10 100 9 12 100 100\n") != std::string::npos);
  CHECK(data.find("# teapot: nowhere\nNaN NaN NaN NaN NaN NaN\n\n\n") != std::string::npos);
  const std::string script = plot_script(small_plot());
  CHECK(script.find("'it''s-small.dat'") != std::string::npos);
  CHECK(script.find("set label 'never wrong'") != std::string::npos);
  CHECK(script.find("data index 1 ") != std::string::npos);
}

TEST_CASE("report: a plot is drawn where gnuplot is installed, and its data are always written") {
  const test::TemporaryFolder folder;
  const PlotFiles files = write_plot(small_plot(), folder.path());
  CHECK(std::filesystem::exists(files.data));
  CHECK(std::filesystem::exists(files.script));
  if (!gnuplot_present()) {
    CHECK(files.svg.empty());
    return;
  }
  REQUIRE_FALSE(files.svg.empty());
  const std::string svg = read_text_file(files.svg);
  CHECK(svg.find("time (ms)") != std::string::npos);
  CHECK(svg.find("never wrong") != std::string::npos);
  CHECK(svg.find("</svg>") != std::string::npos);
  REQUIRE_FALSE(files.png.empty());
  CHECK(std::filesystem::file_size(files.png) > 1000);
}

TEST_CASE("report: a page holds its pictures and tables within itself, and nothing in a text is markup") {
  const test::TemporaryFolder folder;
  const std::filesystem::path svg = folder.path() / "a.svg";
  std::ofstream(svg) << "Man";
  Page page("a < b");
  page.chapter("Times & errors");
  page.plot({"a.dat", "a.gnuplot", svg, {}}, "time against error");
  page.plot({"b.dat", "b.gnuplot", {}, {}}, "nothing");
  page.table({{"name", "ms"}, {{"<painter>", "1.5"}}});
  const std::string html = page.html();
  CHECK(html.find("<h1>a &lt; b</h1>") != std::string::npos);
  CHECK(html.find("data:image/svg+xml;base64,TWFu\"") != std::string::npos);
  CHECK(html.find("its data are in b.dat") != std::string::npos);
  CHECK(html.find("<td>&lt;painter&gt;</td><td class=\"number\">1.5</td>") != std::string::npos);
  CHECK(html.find("http") == std::string::npos);
}

TEST_CASE("report: comma-separated values quote what would break them") {
  CHECK(to_csv({{"name", "ms"}, {{"zbuffer[depth=eye,snap=4]", "1"}, {"say \"so\"", "2"}}}) ==
        "name,ms\r\n\"zbuffer[depth=eye,snap=4]\",1\r\n\"say \"\"so\"\"\",2\r\n");
}

TEST_CASE("report: a journal goes on where a stopped run was, and begins anew for another run") {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "runs.jsonl";
  {
    Journal journal(file, "one");
    journal.add("a \"b\"", "{\"ms\":1.5}");
    journal.add("c", "[2]");
  }
  std::ofstream(file, std::ios::app) << "{\"key\":\"d\",\"value\":";  // cut off in the middle of a line
  {
    Journal journal(file, "one");
    CHECK(journal.taken_over() == 2);
    CHECK(journal.find("a \"b\"") == "{\"ms\":1.5}");
    CHECK_FALSE(journal.find("d"));
    journal.add("d", "3");
  }
  CHECK(Journal(file, "one").find("d") == "3");
  Journal other(file, "two");
  CHECK(other.taken_over() == 0);
  other.finish();
  CHECK_FALSE(std::filesystem::exists(file));
}

TEST_CASE("report: what this machine is can be told") {
  for (const auto& [name, value] : this_machine().rows()) {
    CAPTURE(name);
    CHECK_FALSE(value.empty());
  }
}

}  // namespace hsr::report
