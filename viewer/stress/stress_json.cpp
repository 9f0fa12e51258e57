#include "stress/stress_json.h"

#include <nlohmann/json.hpp>

#include "scene/errors.h"

namespace hsr::stress {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Outcome& outcome) {
  if (!outcome.not_run.empty()) return {{"not_run", outcome.not_run}};
  return {{"wrong", outcome.wrong},         {"holes", outcome.holes},
          {"leaks", outcome.leaks},         {"list_errors", outcome.list_errors},
          {"questions", outcome.questions}, {"to_double", outcome.to_double},
          {"to_exact", outcome.to_exact},   {"ms", outcome.ms}};
}

Outcome outcome_of(const Json& json) {
  Outcome outcome;
  if (json.contains("not_run")) {
    outcome.not_run = json.at("not_run");
    return outcome;
  }
  outcome.wrong = json.at("wrong");
  outcome.holes = json.at("holes");
  outcome.leaks = json.at("leaks");
  outcome.list_errors = json.at("list_errors");
  outcome.questions = json.at("questions");
  outcome.to_double = json.at("to_double");
  outcome.to_exact = json.at("to_exact");
  outcome.ms = json.at("ms");
  return outcome;
}

Json json_of(const Trial& trial) {
  Json json = {{"k", trial.k},
               {"triangles", trial.triangles},
               {"pixels", trial.pixels},
               {"covered", trial.covered},
               {"evidence", trial.evidence},
               {"outcomes", Json::array()}};
  for (const Outcome& outcome : trial.outcomes) json["outcomes"].push_back(json_of(outcome));
  return json;
}

std::string text_of(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string to_json(const Trial& trial) { return text_of(json_of(trial), -1); }

Trial trial_of_json(const std::string& text, const std::vector<Mode>& modes) {
  try {
    const Json json = Json::parse(text);
    Trial trial;
    trial.k = json.at("k");
    trial.triangles = json.at("triangles");
    trial.pixels = json.at("pixels");
    trial.covered = json.at("covered");
    trial.evidence = json.at("evidence");
    for (const Json& outcome : json.at("outcomes")) trial.outcomes.push_back(outcome_of(outcome));
    if (trial.outcomes.size() != modes.size()) throw InputError("a kept trial is of other algorithms");
    return trial;
  } catch (const Json::exception&) {
    throw InputError("a kept trial is broken");
  }
}

std::string to_json(const StressResult& result, const report::Machine& machine) {
  Json json = {{"machine", Json::object()}, {"modes", Json::array()}, {"families", Json::array()}};
  for (const auto& [name, value] : machine.rows()) json["machine"][name] = value;
  for (const Mode& mode : result.modes) {
    json["modes"].push_back({{"name", mode.name}, {"peer", mode.peer != nullptr}, {"exact", mode.exact}});
  }
  for (const FamilyResult& family : result.families) {
    Json row = {{"name", family.family->name},
                {"title", family.family->title},
                {"k_means", family.family->k_means},
                {"differs_to", family.family->differs_to},
                {"evidence", family.family->evidence},
                {"breakdown", Json::object()},
                {"trials", Json::array()}};
    for (std::size_t mode = 0; mode < result.modes.size(); ++mode) {
      const std::optional<int> point = breakdown_point(family, mode);
      row["breakdown"][result.modes[mode].name] = point ? Json(*point) : Json();
    }
    for (const Trial& trial : family.trials) row["trials"].push_back(json_of(trial));
    json["families"].push_back(std::move(row));
  }
  return text_of(json, 1) + "\n";
}

}  // namespace hsr::stress
