#include <nlohmann/json.hpp>

#include "bench/speed.h"

namespace hsr::bench {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Ratio& ratio) {
  return {{"median", ratio.median}, {"quarter_below", ratio.low}, {"quarter_above", ratio.high}};
}

Json json_of(const SpeedRace& race, const SpeedRow& row) {
  if (!row.failed.empty()) return {{"name", row.name}, {"peer", row.peer}, {"failed", row.failed}};
  Json json = {
      {"name", row.name},
      {"peer", row.peer},
      {"prepare_ms", row.prepare_ms},
      {"least_ms", row.timing.least()},
      {"median_ms", row.timing.median()},
      {"ms", row.timing.ms},
      {"wrong", row.errors.wrong},
      {"holes", row.errors.holes},
      {"leaks", row.errors.leaks},
      {"depth_error", row.errors.depth ? Json(row.errors.depth->max) : Json()},
      {"times_as_fast_as_fastest_peer", nullptr},
  };
  if (const std::optional<std::size_t> peer = fastest_peer(race)) {
    json["times_as_fast_as_fastest_peer"] = json_of(ratio(race.rows[*peer].timing, row.timing));
  }
  return json;
}

Json json_of(const SpeedRace& race) {
  Json json = {
      {"scene", race.scene.name},     {"made_by", race.scene.scene}, {"triangles", race.triangles},
      {"width", race.size.width},     {"height", race.size.height},  {"threads", race.threads},
      {"task", name_of(race.task)},   {"covered", race.covered},     {"fastest_peer", nullptr},
      {"contestants", Json::array()},
  };
  if (const std::optional<std::size_t> peer = fastest_peer(race))
    json["fastest_peer"] = race.rows[*peer].name;
  for (const SpeedRow& row : race.rows) json["contestants"].push_back(json_of(race, row));
  return json;
}

}  // namespace

std::string to_json(const std::vector<SpeedRace>& races) {
  Json json = {{"races", Json::array()}};
  for (const SpeedRace& race : races) json["races"].push_back(json_of(race));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace hsr::bench
