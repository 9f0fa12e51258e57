#include "bench/bench_report.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "bench/baseline.h"
#include "bench/bench_plan.h"
#include "bench/bench_run.h"
#include "scene/errors.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"
#include "text_file.h"

namespace hsr::bench {
namespace {

RunRecord run_of(const std::string& name, std::vector<double> ms, std::uint64_t wrong) {
  RunRecord run;
  run.scene = "teapot";
  run.triangles = 6320;
  run.width = 64;
  run.height = 36;
  run.covered = 1000;
  run.name = name;
  run.algorithm = name.substr(0, name.find('['));
  run.render.ms = std::move(ms);
  run.settled = true;
  run.bytes = 12345678901;
  run.skipped["off-screen"] = 7;
  run.counters["fragments"] = 9;
  run.errors.emplace();
  run.errors->wrong = wrong;
  run.errors->depth = {0.1 + 0.2, 1e-9};
  run.lists = exact::ListErrors{1, 2, 3};
  return run;
}

BenchReport report_of(std::vector<RunRecord> runs) {
  BenchReport report;
  report.machine = {{"processor", "\"quoted\""}, {"cores", "2"}};
  report.repeats = "Once.";
  report.runs = std::move(runs);
  return report;
}

}  // namespace

TEST_CASE("bench: the Pareto front has those whom nobody beats in both, by time") {
  const std::vector<Cost> costs = {{5.0, 0.0}, {1.0, 9.0}, {2.0, 9.0}, {3.0, 4.0}, {6.0, 0.0}, {3.0, 5.0}};
  CHECK(pareto_front(costs) == std::vector<std::size_t>{1, 3, 0});
  CHECK(pareto_front({{1.0, 1.0}, {1.0, 1.0}}) == std::vector<std::size_t>{0});
  CHECK(pareto_front({}).empty());
}

TEST_CASE("bench: the exponent of a law is found, with its error, and not from what is too small") {
  std::vector<Sample> samples;
  for (const double x : {10.0, 100.0, 1000.0, 10000.0}) samples.push_back({x, 3.0 * std::pow(x, 1.5)});
  const std::optional<PowerLaw> law = fit_power_law(samples);
  REQUIRE(law);
  CHECK(law->exponent == doctest::Approx(1.5));
  CHECK(law->factor == doctest::Approx(3.0));
  CHECK(law->error < 1e-6);
  samples.front().y = 1e6;  // what is fixed
  CHECK(fit_power_law(samples)->error > 0.1);
  CHECK(fit_power_law(samples, 50.0)->exponent == doctest::Approx(1.5));
  CHECK_FALSE(fit_power_law(samples, 5000.0));
  CHECK_FALSE(fit_power_law({{1.0, 0.0}, {2.0, 1.0}}));
}

TEST_CASE("bench: a report read back is the one that was written") {
  RunRecord failed = run_of("painter[key=mean]", {}, 0);
  failed.failed = "stopped after 1.00 s";
  failed.errors.reset();
  failed.lists.reset();
  BenchReport report = report_of({run_of("zbuffer", {1.25, 1.0 / 3.0}, 4), failed});
  report.costs = {{"depth sort", "newell", 100, {{"cuts", 3}}, 5, 6, 1.5, 2.5, ""}};
  const BenchReport again = report_from_json(to_json(report));
  REQUIRE(again.runs.size() == 2);
  CHECK(again.machine == report.machine);
  CHECK(again.runs[0].render.ms == report.runs[0].render.ms);
  CHECK(again.runs[0].errors->depth->max == report.runs[0].errors->depth->max);
  CHECK(again.runs[0].bytes == 12345678901);
  CHECK(again.runs[0].lists->inversions == 3);
  CHECK(again.runs[1].failed == failed.failed);
  CHECK_FALSE(again.runs[1].errors);
  CHECK(again.costs.front().operations == report.costs.front().operations);
  CHECK(to_json(again) == to_json(report));
  CHECK_THROWS_AS(report_from_json("{\"runs\": 3}"), InputError);
  CHECK_THROWS_AS(report_from_json("hello"), InputError);
}

TEST_CASE("bench: a comparison tells slower from noise, and takes any new error for one") {
  const BenchReport before =
      report_of({run_of("a", {10.0, 10.1, 10.2}, 0), run_of("b", {10.0, 15.0, 20.0}, 0),
                 run_of("c", {10.0, 10.0, 10.0}, 3), run_of("d", {10.0, 10.0, 10.0}, 3)});
  const BenchReport after = report_of({run_of("a", {12.0, 12.1, 12.2}, 0), run_of("b", {12.0, 18.0, 24.0}, 0),
                                       run_of("c", {10.2, 10.2, 10.2}, 4), run_of("d", {8.0, 8.0, 8.0}, 2)});
  const Baseline baseline = compare_reports(before, after);
  CHECK(baseline.worse());
  REQUIRE(baseline.changes.size() == 3);
  CHECK(baseline.changes[0].after->name == "a");
  CHECK(baseline.changes[0].slower);
  CHECK(baseline.changes[1].after->name == "c");
  CHECK(baseline.changes[1].more_wrong == "wrong 3 -> 4");
  CHECK_FALSE(baseline.changes[1].slower);
  CHECK(baseline.changes[2].faster);
  CHECK(baseline.changes[2].less_wrong == "wrong 3 -> 2");
  CHECK_FALSE(compare_reports(before, before).worse());
  CHECK(compare_reports(before, report_of({})).worse());
}

TEST_CASE("bench: times are compared after the drift of other programs, and not between machines") {
  BenchReport before = report_of({run_of("a", {10.0, 10.0, 10.0}, 0), run_of("peer", {5.0, 5.0, 5.0}, 0)});
  BenchReport after = report_of({run_of("a", {13.0, 13.0, 13.0}, 0), run_of("peer", {6.5, 6.5, 6.5}, 0)});
  before.runs[1].peer = after.runs[1].peer = true;
  CHECK(compare_reports(before, after).drift == doctest::Approx(1.3));
  CHECK_FALSE(compare_reports(before, after).worse());
  after.runs.front().render.ms = {26.0, 26.0, 26.0};
  CHECK(compare_reports(before, after).worse());
  after.machine.front().second = "another";
  CHECK_FALSE(compare_reports(before, after).worse());
}

TEST_CASE("bench: every setting has its turn, one at a time") {
  std::vector<std::string> names;
  for (const AlgorithmSpec& spec : with_each_setting(*find_algorithm("zbuffer")))
    names.push_back(spec.text());
  CHECK(names == std::vector<std::string>{
                     "zbuffer", "zbuffer[depth=eye]", "zbuffer[depth=reversed32]", "zbuffer[depth=float32]",
                     "zbuffer[depth=unorm24]", "zbuffer[depth=unorm16]", "zbuffer[snap=2]", "zbuffer[snap=4]",
                     "zbuffer[snap=8]", "zbuffer[snap=16]", "zbuffer[transparency=blend]"});
  CHECK(with_each_setting(*find_algorithm("newell")).size() == 1 + 1 + 1 + 6 + 1);
}

TEST_CASE("bench: the time that is left is what it took so far, on") {
  TimeLeft left(10.0);
  CHECK(left.text(1000.0).empty());
  left.step(5.0);
  CHECK(left.text(20'000.0) == "20 s left");
  CHECK(left.text(200'000.0) == "4 min left");
  left.without(5.0);
  CHECK(left.share() == 1.0);
}

TEST_CASE("bench: a stopped run goes on where it was") {
  const test::TemporaryFolder folder;
  BenchCommand command;
  command.chosen_scenes = {"cube", "crossing"};
  command.sizes = {{16, 9}};
  command.algorithms = {parse_algorithm_spec("zbuffer"), parse_algorithm_spec("painter")};
  command.threads = {1};
  command.peers = false;
  command.quick = true;
  command.seconds = 0.001;
  const BenchPlan plan = make_plan(command);
  report::Journal journal(folder / "runs.jsonl", identity(command));
  BenchPlan first = plan;
  first.cells.resize(1);
  const BenchReport stopped = run_plan(first, &journal, {});
  report::Journal taken_up(folder / "runs.jsonl", identity(command));
  CHECK(taken_up.taken_over() == 1);
  const BenchReport whole = run_plan(plan, &taken_up, {});
  REQUIRE(whole.runs.size() == 2 * stopped.runs.size());
  // Two algorithms as they are, and without each of their two skips.
  CHECK(stopped.runs.size() == 6);
  CHECK(to_json(whole.runs[0]) == to_json(stopped.runs[0]));
  CHECK(whole.runs[6].scene == "crossing");
  CHECK(whole.runs[6].wrong_pixels() == 0);
  CHECK(whole.runs[9].name == "painter");
  CHECK(whole.runs[9].wrong_pixels() > 0);
  CHECK_FALSE(whole.runs[9].render.ms.empty());
  command.quick = false;
  CHECK(report::Journal(folder / "runs.jsonl", identity(command)).taken_over() == 0);
}

TEST_CASE("bench: the program writes a page, figures and plots, and compares them") {
  const test::TemporaryFolder folder;
  const std::string out = folder.path().string();
  const test::ProgramRun run =
      test::run_program({"bench", "crossing", "-a", "zbuffer,zbuffer[depth=unorm16],painter", "-s", "32x18",
                         "--threads", "1", "--quick", "--seconds", "0.001", "--no-peers", "-o", out});
  CHECK(run.err.empty());
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("crossing, 32x18: ") != std::string::npos);
  for (const char* file : {"index.html", "bench.json", "bench.csv", "tradeoff-crossing-32x18.dat"}) {
    CAPTURE(file);
    CHECK(std::filesystem::exists(folder / file));
  }
  CHECK_FALSE(std::filesystem::exists(folder / "runs.jsonl"));
  const std::string json = (folder / "bench.json").string();
  CHECK(test::run_program({"bench", "--compare", json, json}).exit_code == 0);
  const test::ProgramRun unknown = test::run_program({"bench", "--only", "tradeof"});
  CHECK(unknown.exit_code == 2);
  CHECK(unknown.err.find("tradeoff") != std::string::npos);
  CHECK(test::run_program({"bench", "cube", "nosuchscene", "--quick"}).exit_code == 2);
}

TEST_CASE("bench: a machine in which something became more wrong gets exit code 1") {
  const test::TemporaryFolder folder;
  const auto before = folder.write("old.json", to_json(report_of({run_of("zbuffer", {1.0}, 0)})));
  const auto after = folder.write("new.json", to_json(report_of({run_of("zbuffer", {1.0}, 1)})));
  const test::ProgramRun run = test::run_program({"bench", "--compare", before.string(), after.string()});
  CHECK(run.exit_code == 1);
  CHECK(run.out.find("wrong 0 -> 1") != std::string::npos);
}

}  // namespace hsr::bench
