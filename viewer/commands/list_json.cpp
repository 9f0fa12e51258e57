#include "commands/list_json.h"

#include <nlohmann/json.hpp>

#include "algorithm.h"
#include "scene/catalog.h"

namespace hsr {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json to_json(const Setting& setting) {
  Json json = {{"name", setting.name}, {"meaning", setting.meaning}, {"choices", setting.choices}};
  json["range"] = nullptr;
  if (!setting.parts.empty()) json["parts"] = setting.parts;
  if (setting.range) json["range"] = {{"least", setting.range->least}, {"greatest", setting.range->greatest}};
  return json;
}

Json settings_of(const Algorithm& algorithm) {
  Json settings = Json::array();
  for (const Setting& setting : algorithm.settings) settings.push_back(to_json(setting));
  return settings;
}

Json to_json(const Traits& traits) {
  return {{"time", traits.time},
          {"memory", traits.memory},
          {"transparency", traits.transparency},
          {"cycles", traits.cycles},
          {"exact", traits.exact}};
}

Json to_json(const Algorithm& algorithm) {
  Json json = {{"name", algorithm.name},
               {"title", algorithm.title},
               {"idea", algorithm.idea},
               {"source", algorithm.source},
               {"variant_of", nullptr},
               {"traits", to_json(algorithm.traits)},
               {"settings", settings_of(algorithm)},
               {"skips", Json::array()}};
  if (!algorithm.variant_of.empty()) json["variant_of"] = algorithm.variant_of;
  for (const Skip& skip : algorithm.skips) {
    json["skips"].push_back({{"name", skip.name}, {"meaning", skip.meaning}});
  }
  return json;
}

Json to_json(const SceneEntry& entry) {
  Json json = {
      {"name", entry.name}, {"title", entry.title}, {"shows", entry.shows}, {"parameters", Json::array()}};
  for (const SceneParameter& parameter : entry.parameters) {
    json["parameters"].push_back({{"name", parameter.name},
                                  {"meaning", parameter.meaning},
                                  {"default", parameter.default_value},
                                  {"least", parameter.least},
                                  {"greatest", parameter.greatest},
                                  {"whole", parameter.whole}});
  }
  return json;
}

}  // namespace

std::string scenes_json() {
  Json scenes = Json::array();
  for (const SceneEntry& entry : scene_catalog()) scenes.push_back(to_json(entry));
  return text_of({{"scenes", scenes}});
}

std::string algorithms_json() {
  Json algorithms = Json::array();
  for (const Algorithm* algorithm : algorithm_catalog()) algorithms.push_back(to_json(*algorithm));
  return text_of({{"default", default_algorithm().name}, {"algorithms", algorithms}});
}

std::string settings_json() {
  Json algorithms = Json::array();
  for (const Algorithm* algorithm : algorithm_catalog()) {
    algorithms.push_back({{"algorithm", algorithm->name}, {"settings", settings_of(*algorithm)}});
  }
  return text_of({{"algorithms", algorithms}});
}

}  // namespace hsr
