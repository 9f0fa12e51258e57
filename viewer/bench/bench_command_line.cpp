#include "bench/bench_command_line.h"

#include <algorithm>

#include "lanes/instruction_sets.h"
#include "nearest_name.h"
#include "option_helpers.h"
#include "scene/errors.h"

namespace hsr {
namespace {

constexpr int greatest_threads = 1024;

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char letter : text) {
    if (letter == ',') {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

std::vector<std::string> parse_instruction_sets(const std::string& option, const std::string& text) {
  const std::vector<std::string_view> known = lanes::instruction_sets();
  if (text == "all") return {known.begin(), known.end()};
  std::vector<std::string> sets = split(text);
  for (const std::string& set : sets) {
    if (std::ranges::find(known, set) == known.end()) {
      throw UsageError(option + ": this machine has no \"" + set + "\"" + what_there_is(set, known));
    }
  }
  return sets;
}

}  // namespace

void add_bench(CLI::App& program, BenchCommand& command) {
  CLI::App& app = *program.add_subcommand(
      "bench", "Measure run time against error: every algorithm and setting, beside other programs.");
  app.add_option(
         "SCENE", command.chosen_scenes,
         "Scenes for time against error (default: ten built-in ones). Growth and the table of 1974 are "
         "measured only if no scene is named, or with --only.")
      ->type_name("");
  app.add_flag(
      "--speed", command.speed,
      "Instead, race the fast versions against each other and against other programs, in turn in one run, on "
      "the scenes that speed is measured on; each picture is held against the exact answer.");
  app.add_flag(
      "--quick", command.quick,
      "Fewer scenes, smaller pictures and fewer runs: under a minute (with --speed a minute or two).");
  add_file(app, "-o,--output", "DIR", command.folder,
           "Write all figures into a folder: index.html with plots and tables, bench.json, bench.csv, every "
           "plot as SVG and PNG with its data. A run that was stopped goes on where it was. With --speed: "
           "speed.json.");
  app.add_option_function<std::vector<std::string>>(
         "--compare",
         [&command](const std::vector<std::string>& files) {
           command.compare = {files[0], files[1]};
         },
         "Run nothing; say what became slower or more wrong from one bench.json to another, noise taken into "
         "account. Exit code 1 if anything did, else 0.")
      ->type_name("OLD.json NEW.json")
      ->expected(2);
  add_value(
      app, "--only", "WHAT,...", [&command](const auto&, const auto& text) { command.only = split(text); },
      "tradeoff (time against error, skips, structures, threads), growth with triangles, pixels or depth, "
      "1974 (the table of 1974).");
  add_value(
      app, "--scenes", "NAME,...",
      [&command](const auto&, const auto& text) { command.scenes = split(text); },
      "The same with commas between; with --speed also sphere70k, sphere1M, soup100k ... (default: all of "
      "its "
      "table).");
  add_value(
      app, "-s,--size", "WxH,...",
      [&command](const auto& option, const auto& text) {
        for (const std::string& size : split(text)) command.sizes.push_back(parse_size(option, size));
      },
      "Sizes of the picture in pixels (default 640x360; with --speed 640x480,1920x1080).");
  add_value(
      app, "-a,--algorithm", "SPEC,...",
      [&command](const auto& option, const auto& text) {
        command.algorithms = with_option_named(option, [&] { return parse_algorithm_specs(text); });
      },
      "Exactly these algorithms (default: all, with each of their settings; with --speed the fast ones that "
      "are exact, and the textbook z-buffer).");
  add_value(
      app, "--threads", "N,...",
      [&command](const auto& option, const auto& text) {
        for (const std::string& count : split(text)) {
          command.threads.push_back(parse_whole_number(option, count, 1, greatest_threads));
        }
      },
      "Numbers of threads (default: one, and one per core).");
  add_value(
      app, "--instruction-sets", "NAME,...",
      [&command](const auto& option, const auto& text) {
        command.instruction_sets = parse_instruction_sets(option, text);
      },
      "Which instruction sets the fast versions use, or all that the machine has (default: the best).");
  app.add_flag_callback(
      "--no-peers", [&command] { command.peers = false; }, "Without other programs.");
  add_value(
      app, "--seconds", "N",
      [&command](const auto& option, const auto& text) {
        command.seconds = parse_number(option, text);
        if (!(*command.seconds > 0.0)) throw UsageError(option + ": must be above 0");
      },
      "How long all runs of one algorithm on one scene may take (default 1); with --speed, how long a race "
      "may "
      "last before its last round (default 5).");
  app.footer(
      "Examples: hsr bench --quick -o bench\n          hsr bench teapot model.ply -a zbuffer,raycast-fast -o "
      "bench\n          hsr bench --speed --scenes sphere70k,soup100k --threads 1 -o speed");
}

}  // namespace hsr
