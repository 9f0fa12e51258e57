#include "bench/bench_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "scene/errors.h"

namespace hsr::bench {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Tradeoff& tradeoff) {
  Json json = {{"scene", tradeoff.scene},
               {"width", tradeoff.width},
               {"height", tradeoff.height},
               {"front", Json::array()}};
  for (const RunRecord* run : tradeoff.front) {
    json["front"].push_back({{"name", run->name},
                             {"median_ms", run->render.median()},
                             {"errors_per_million", run->errors_per_million().value_or(0.0)}});
  }
  return json;
}

Json json_of(const Growth& growth, Question question) {
  Json json = {{"with", name_of(question)}, {"name", growth.name}, {"exponent", nullptr}};
  if (growth.law) {
    json["exponent"] = growth.law->exponent;
    json["standard_error"] = growth.law->error;
  }
  return json;
}

}  // namespace

std::string to_json(const BenchReport& report) {
  Json json = {{"machine", Json::object()},
               {"repeats", report.repeats},
               {"fronts", Json::array()},
               {"growth", Json::array()},
               {"costs_1974", Json::parse(to_json(report.costs))}};
  for (const auto& [name, value] : report.machine) json["machine"][name] = value;
  for (const Tradeoff& tradeoff : tradeoffs(report.runs)) json["fronts"].push_back(json_of(tradeoff));
  for (const Question question : {Question::triangles, Question::pixels, Question::depth}) {
    for (const Growth& growth : growths(report.runs, question))
      json["growth"].push_back(json_of(growth, question));
  }
  // A run to a line, so that files can be compared by eye.
  std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace);
  text.erase(text.rfind("\n}"));
  text += ",\n  \"runs\": [";
  for (std::size_t k = 0; k < report.runs.size(); ++k)
    text += (k == 0 ? "\n    " : ",\n    ") + to_json(report.runs[k]);
  return text + "\n  ]\n}\n";
}

BenchReport report_from_json(const std::string& text) {
  try {
    const Json json = Json::parse(text);
    BenchReport report;
    for (const auto& [name, value] : json.at("machine").items())
      report.machine.emplace_back(name, value.get<std::string>());
    report.repeats = json.at("repeats");
    for (const Json& run : json.at("runs"))
      report.runs.push_back(record_from_json(run.dump(-1, ' ', false, Json::error_handler_t::replace)));
    report.costs = costs_from_json(json.at("costs_1974").dump());
    return report;
  } catch (const Json::exception& error) {
    throw InputError(std::string("no report of hsr bench: ") + error.what());
  }
}

std::vector<Tradeoff> tradeoffs(const std::vector<RunRecord>& runs) {
  std::vector<Tradeoff> all;
  for (const RunRecord& run : runs) {
    if (run.question != Question::tradeoff) continue;
    auto found = std::ranges::find_if(all, [&](const Tradeoff& tradeoff) {
      return tradeoff.scene == run.scene && tradeoff.width == run.width && tradeoff.height == run.height;
    });
    if (found == all.end()) found = all.insert(all.end(), {run.scene, run.width, run.height, {}, {}});
    const bool alike = found->runs.empty() || found->runs.front()->threads == run.threads;
    if (alike && run.skip_off.empty() && run.failed.empty() && !run.render.ms.empty() &&
        run.errors_per_million())
      found->runs.push_back(&run);
  }
  for (Tradeoff& tradeoff : all) {
    std::vector<Cost> costs;
    for (const RunRecord* run : tradeoff.runs)
      costs.push_back({run->render.median(), run->errors_per_million().value_or(0.0)});
    for (const std::size_t place : pareto_front(costs)) tradeoff.front.push_back(tradeoff.runs[place]);
  }
  return all;
}

std::vector<Growth> growths(const std::vector<RunRecord>& runs, Question question) {
  std::vector<Growth> all;
  for (const RunRecord& run : runs) {
    if (run.question != question || !run.failed.empty() || run.render.ms.empty()) continue;
    auto found = std::ranges::find(all, run.name, &Growth::name);
    if (found == all.end()) found = all.insert(all.end(), {run.name, run.peer, {}, {}});
    found->runs.push_back(&run);
  }
  for (Growth& growth : all) {
    std::ranges::sort(growth.runs, {}, &RunRecord::parameter);
    std::vector<Sample> samples;
    for (const RunRecord* run : growth.runs) samples.push_back({run->parameter, run->render.median()});
    const double last = samples.back().x;
    const double range = last / samples.front().x;
    constexpr double two_decades = 101.0;
    // Where what is fixed no longer hides what grows, as far as the range goes.
    if (range > 1.0) growth.law = fit_power_law(samples, last / (range > two_decades ? two_decades : 10.1));
  }
  return all;
}

std::vector<SkipGain> skip_gains(const std::vector<RunRecord>& runs) {
  std::vector<SkipGain> gains;
  for (const RunRecord& without : runs) {
    if (without.skip_off.empty() || without.render.ms.empty() || !without.failed.empty()) continue;
    RunRecord same = without;
    same.skip_off.clear();
    const std::string key = same.key();
    const auto with = std::ranges::find_if(runs, [&](const RunRecord& run) { return run.key() == key; });
    if (with == runs.end() || with->render.ms.empty() || !with->failed.empty()) continue;
    gains.push_back({&*with, &without, without.render.median() / with->render.median(),
                     without.render.at(0.25) / with->render.at(0.75),
                     without.render.at(0.75) / with->render.at(0.25)});
  }
  return gains;
}

}  // namespace hsr::bench
