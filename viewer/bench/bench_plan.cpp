#include "bench/bench_plan.h"

#include <algorithm>
#include <thread>

#include "nearest_name.h"
#include "scene/errors.h"

namespace hsr::bench {
namespace {

constexpr int usual_depth = 4;  // sheets, where something else grows

AlgorithmSpec with_setting(const Algorithm& algorithm, std::string_view setting, const std::string& value) {
  return parse_algorithm_spec(std::string(algorithm.name) + "[" + std::string(setting) + "=" + value + "]");
}

std::string all_but(std::span<const std::string_view> parts, std::string_view left_out) {
  std::string text;
  for (const std::string_view part : parts) {
    if (part != left_out) text.append(text.empty() ? "" : "+").append(part);
  }
  return text;
}

int all_cores() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

std::vector<int> thread_counts(const BenchCommand& command) {
  if (!command.threads.empty()) return command.threads;
  return all_cores() == 1 ? std::vector<int>{1} : std::vector<int>{1, all_cores()};
}

void add_peers(const BenchCommand& command, const std::vector<int>& threads, std::vector<Entry>& entries) {
  if (!command.peers) return;
  for (const PeerEntry& peer : peer_table()) {
    if (peer.task != Task::nearest || peer_program(peer).empty()) continue;
    for (const int count : threads) entries.push_back({{}, &peer, count});
  }
}

/// For the trade-off: every setting on the first number of threads, the defaults on all of them and with each
/// skip off. Algorithms that were named run as they were named.
std::vector<Entry> all_entries(const BenchCommand& command) {
  const std::vector<int> threads = thread_counts(command);
  std::vector<AlgorithmSpec> specs = command.algorithms;
  if (specs.empty()) {
    for (const Algorithm* algorithm : algorithm_catalog()) {
      const std::vector<AlgorithmSpec> each = with_each_setting(*algorithm);
      specs.insert(specs.end(), each.begin(), each.end());
    }
  }
  std::vector<Entry> entries;
  for (const AlgorithmSpec& spec : specs) {
    entries.push_back({spec, nullptr, threads.front()});
    const bool usual = spec.text() == spec.algorithm->name;
    if (!usual && command.algorithms.empty()) continue;
    for (std::size_t k = 1; k < threads.size(); ++k) entries.push_back({spec, nullptr, threads[k]});
    for (const Skip& skip : spec.algorithm->skips)
      entries.push_back({spec, nullptr, threads.front(), std::string(skip.name)});
  }
  add_peers(command, threads, entries);
  return entries;
}

/// For growth: the defaults, other structures, and peers, on one thread.
std::vector<Entry> few_entries(const BenchCommand& command) {
  const int threads = thread_counts(command).front();
  std::vector<AlgorithmSpec> specs = command.algorithms;
  if (specs.empty()) {
    for (const Algorithm* algorithm : algorithm_catalog())
      specs.push_back(parse_algorithm_spec(algorithm->name));
    for (const char* other :
         {"raycast[structure=grid]", "raycast[structure=none]", "raycast-fast[build=lbvh]"})
      specs.push_back(parse_algorithm_spec(other));
  }
  std::vector<Entry> entries;
  for (const AlgorithmSpec& spec : specs) entries.push_back({spec, nullptr, threads});
  add_peers(command, {threads}, entries);
  return entries;
}

void add_tradeoff(const BenchCommand& command, BenchPlan& plan) {
  std::vector<std::string> scenes = command.chosen_scenes;
  scenes.insert(scenes.end(), command.scenes.begin(), command.scenes.end());
  if (scenes.empty() && command.quick) scenes = {"teapot", "crossing"};
  if (scenes.empty())
    scenes = {"teapot",  "crossing", "three-bars", "needles",      "hair-apart",
              "stadium", "city:12",  "glass",      "bumpy-sphere", "soup"};
  std::vector<Size> sizes = command.sizes;
  if (sizes.empty()) sizes = {command.quick ? Size{256, 144} : Size{640, 360}};
  const std::vector<Entry> entries = all_entries(command);
  for (const std::string& scene : scenes) {
    for (const Size size : sizes) plan.cells.push_back({Question::tradeoff, scene, size, 0.0, entries, true});
  }
}

void add_triangles(const BenchCommand& command, BenchPlan& plan) {
  std::vector<int> counts = {100, 300, 1000, 3000, 10'000, 30'000, 100'000, 300'000, 1'000'000};
  if (command.quick) counts = {100, 1000, 10'000};
  Size size = command.quick ? Size{320, 180} : Size{640, 360};
  if (!command.sizes.empty()) size = command.sizes.front();
  for (const int count : counts)
    plan.cells.push_back({Question::triangles, sheets_scene(count, usual_depth), size,
                          static_cast<double>(count), few_entries(command)});
}

void add_pixels(const BenchCommand& command, BenchPlan& plan) {
  std::vector<Size> sizes = {{160, 90}, {320, 180}, {640, 360}, {1280, 720}, {1920, 1080}};
  if (command.quick) sizes = {{80, 45}, {160, 90}, {320, 180}};
  for (const Size size : sizes)
    plan.cells.push_back({Question::pixels, sheets_scene(command.quick ? 1000 : 2500, usual_depth), size,
                          static_cast<double>(size.width) * size.height, few_entries(command)});
}

void add_depth(const BenchCommand& command, BenchPlan& plan) {
  std::vector<int> depths = {1, 2, 4, 8, 16, 32, 64};
  if (command.quick) depths = {1, 4, 16};
  Size size = command.quick ? Size{160, 90} : Size{640, 360};
  if (!command.sizes.empty()) size = command.sizes.front();
  for (const int depth : depths)
    plan.cells.push_back({Question::depth, sheets_scene(command.quick ? 1000 : 2500, depth), size,
                          static_cast<double>(depth), few_entries(command)});
}

bool wanted(const BenchCommand& command, std::string_view question) {
  if (!command.only.empty()) return std::ranges::find(command.only, question) != command.only.end();
  // Whoever names scenes asks about these.
  return question == "tradeoff" || (command.chosen_scenes.empty() && command.scenes.empty());
}

void check_questions(const std::vector<std::string>& only) {
  std::vector<std::string_view> known(std::begin(question_names), std::end(question_names));
  known.emplace_back("1974");
  for (const std::string& name : only) {
    if (std::ranges::find(known, name) == known.end())
      throw UsageError("--only: unknown question \"" + name + "\"" + what_there_is(name, known));
  }
}

}  // namespace

std::string sheets_scene(int triangles, int depth) {
  return "sheets:" + std::to_string(triangles) + ":" + std::to_string(depth);
}

std::vector<AlgorithmSpec> with_each_setting(const Algorithm& algorithm) {
  std::vector<AlgorithmSpec> specs = {parse_algorithm_spec(algorithm.name)};
  for (const Setting& setting : algorithm.settings) {
    const std::string usual = specs.front().settings.find(setting.name)->second;
    for (const std::string_view choice : setting.choices) {
      if (choice != usual) specs.push_back(with_setting(algorithm, setting.name, std::string(choice)));
    }
    if (setting.range) {
      constexpr int doublings = 3;
      for (int k = 0, value = setting.range->least; k <= doublings && value <= setting.range->greatest;
           ++k, value *= 2)
        specs.push_back(with_setting(algorithm, setting.name, std::to_string(value)));
    }
    for (const std::string_view part : setting.parts)
      specs.push_back(with_setting(algorithm, setting.name, all_but(setting.parts, part)));
  }
  return specs;
}

BenchPlan make_plan(const BenchCommand& command) {
  check_questions(command.only);
  BenchPlan plan;
  plan.all_threads = all_cores();
  if (command.quick) {
    plan.limits = {.least = 3, .most = 9, .seconds = 0.03};
    plan.most_seconds = 0.5;
  }
  if (command.seconds) {
    constexpr double times = 10.0;
    constexpr double least = 0.5;
    plan.limits.seconds = *command.seconds;
    plan.most_seconds = std::max(least, times * *command.seconds);
  }
  if (wanted(command, "tradeoff")) add_tradeoff(command, plan);
  if (wanted(command, "triangles")) add_triangles(command, plan);
  if (wanted(command, "pixels")) add_pixels(command, plan);
  if (wanted(command, "depth")) add_depth(command, plan);
  if (wanted(command, "1974"))
    plan.faces_of_1974 = command.quick ? std::vector<int>{100, 2500} : std::vector<int>{100, 2500, 60'000};
  return plan;
}

}  // namespace hsr::bench
