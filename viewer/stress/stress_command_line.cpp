#include "stress/stress_command_line.h"

#include <string>

#include "option_helpers.h"
#include "stress/family.h"
#include "values.h"

namespace hsr {
namespace {

constexpr int greatest_threads = 1024;

}  // namespace

void add_stress(CLI::App& program, StressCommand& command) {
  CLI::App& app = *program.add_subcommand(
      "stress", "Make scenes harder and harder, and find where each algorithm breaks.");
  std::string names;
  for (const stress::Family& family : stress::families()) {
    names.append(names.empty() ? "" : ", ").append(family.name);
  }
  app.add_option("FAMILY", command.families, "Which families of scenes (default: all): " + names + ".")
      ->type_name("");
  app.add_flag("--quick", command.quick,
               "Six or seven difficulties of each family instead of dozens: less than a minute.");
  add_file(app, "-o,--output", "DIR", command.folder,
           "Write everything into a folder: stress.html, stress.json, tables as CSV, plots. A run that was "
           "stopped goes on where it was when it is begun again with the same folder.");
  add_value(
      app, "-a,--algorithm", "SPEC,...",
      [&command](const auto& option, const auto& text) {
        command.algorithms = with_option_named(option, [&] { return parse_algorithm_specs(text); });
      },
      "Which algorithms (default: every one, with every value of its settings that can change what is "
      "seen).");
  app.add_flag_callback(
      "--no-peers", [&command] { command.peers = false; }, "Without other programs.");
  add_value(
      app, "--threads", "N",
      [&command](const auto& option, const auto& text) {
        command.threads = parse_whole_number(option, text, 1, greatest_threads);
      },
      "How many algorithms are tried at once (default: one per core).");
  app.footer("Example: hsr stress planes-apart kettner -a zbuffer[depth=float32],raycast[test=watertight]");
}

}  // namespace hsr
