#include <algorithm>
#include <ostream>
#include <thread>

#include "bench/bench_command.h"
#include "bench/peers.h"
#include "bench/speed.h"
#include "commands/commands.h"
#include "output_file.h"
#include "picture.h"
#include "scene/atomic_file.h"
#include "text_layout.h"

namespace hsr {
namespace {

/// The rows of the table of scenes that have this name, or a scene as on the command line.
bench::SpeedScene speed_scene(const std::string& name) {
  for (const bench::SpeedScene& scene : bench::speed_scenes()) {
    if (scene.name == name) return scene;
  }
  return {name, name, "", false};
}

std::vector<int> usual_threads() {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return cores == 1 ? std::vector<int>{1} : std::vector<int>{1, cores};
}

bench::SpeedPlan plan_of(const BenchCommand& command) {
  bench::SpeedPlan plan;
  for (const std::string& name : command.chosen_scenes) plan.scenes.push_back(speed_scene(name));
  for (const std::string& name : command.scenes) plan.scenes.push_back(speed_scene(name));
  if (plan.scenes.empty()) {
    for (const bench::SpeedScene& scene : bench::speed_scenes()) {
      if (scene.measuring || !command.quick) plan.scenes.push_back(scene);
    }
  }
  plan.sizes = command.sizes;
  if (plan.sizes.empty()) plan.sizes = {{1920, 1080}};
  if (command.sizes.empty() && !command.quick) plan.sizes.insert(plan.sizes.begin(), {640, 480});
  plan.threads = command.threads.empty() ? usual_threads() : command.threads;
  plan.instruction_sets = command.instruction_sets;
  if (plan.instruction_sets.empty()) plan.instruction_sets = {""};
  plan.algorithms = command.algorithms;
  plan.peers = command.peers;
  plan.limits.seconds = command.seconds.value_or(command.quick ? 1.0 : 5.0);
  if (command.quick) plan.limits.least_rounds = 3;
  return plan;
}

void tell_missing_peers(std::ostream& out) {
  std::string missing;
  for (const bench::PeerEntry& peer : bench::peer_table()) {
    if (!bench::peer_program(peer).empty()) continue;
    if (missing.find(peer.program) == std::string::npos)
      missing += (missing.empty() ? "" : ", ") + std::string(peer.program);
  }
  if (!missing.empty())
    out << paragraph("Not built, as their libraries are not installed: " + missing + ".") << "\n";
}

/// hsr bench --speed.
void race(const BenchCommand& command, std::ostream& out) {
  const std::optional<std::filesystem::path> file =
      command.folder ? std::optional(*command.folder / "speed.json") : std::nullopt;
  if (command.folder) make_folder(*command.folder);
  if (file) require_place(*file);
  const bench::SpeedPlan plan = plan_of(command);
  if (plan.peers) tell_missing_peers(out);
  ProgressBar bar;
  std::vector<bench::SpeedRace> races;
  bench::run_speed(plan, bar.listener(), [&](const bench::SpeedRace& race) {
    bar.erase();
    out << bench::to_text(race) << std::endl;
    races.push_back(race);
    // After every race: what is finished is not lost if the rest is stopped.
    if (file)
      write_file_atomically(*file,
                            [&](const auto& temporary) { write_bytes(temporary, bench::to_json(races)); });
  });
  bar.erase();
  if (file) out << "Wrote " << file->string() << ".\n";
}

}  // namespace

void run(const BenchCommand& command, std::ostream& out) {
  if (command.compare) {
    bench::run_comparison(command, out);
  } else if (command.speed) {
    race(command, out);
  } else {
    bench::run_bench(command, out);
  }
}

}  // namespace hsr
