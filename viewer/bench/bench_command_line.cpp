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
  CLI::App& app =
      *program.add_subcommand("bench", "Measure how fast the algorithms are, beside other programs.");
  app.add_flag(
      "--speed", command.speed,
      "Race the fast versions against each other and against other programs, in turn in one run, on the "
      "scenes that speed is measured on; each picture is held against the exact answer.");
  app.add_flag("--quick", command.quick, "Fewer scenes and rounds: a minute or two.");
  add_file(app, "-o,--output", "DIR", command.folder, "Write all figures into a folder, as speed.json.");
  add_value(
      app, "--scenes", "NAME,...",
      [&command](const auto&, const auto& text) { command.scenes = split(text); },
      "Which scenes: sphere70k, sphere1M, soup100k ..., or any SCENE (default: all of the table).");
  add_value(
      app, "-s,--size", "WxH,...",
      [&command](const auto& option, const auto& text) {
        for (const std::string& size : split(text)) command.sizes.push_back(parse_size(option, size));
      },
      "Sizes of the picture in pixels (default 640x480,1920x1080).");
  add_value(
      app, "-a,--algorithm", "SPEC,...",
      [&command](const auto& option, const auto& text) {
        command.algorithms = with_option_named(option, [&] { return parse_algorithm_specs(text); });
      },
      "Which algorithms (default: the fast ones that are exact, and the textbook z-buffer).");
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
      "How long a race may last before its last round (default 5).");
  app.footer("Example: hsr bench --speed --scenes sphere70k,soup100k --threads 1 -o speed");
}

}  // namespace hsr
