#include <nlohmann/json.hpp>

#include "comparison.h"

namespace hsr {
namespace {

using Json = nlohmann::ordered_json;

Json causes(const ComparedAlgorithm& compared) {
  Json json = Json::object();
  for (std::size_t cause = 0; cause < cause_count; ++cause) json[cause_names[cause]] = compared.causes[cause];
  return json;
}

Json worst_pairs(const ComparedAlgorithm& compared) {
  Json json = Json::array();
  for (const FailingPair& pair : compared.worst_pairs) {
    json.push_back({{"shown", pair.shown},
                    {"nearest", pair.nearest},
                    {"cause", name_of(pair.cause)},
                    {"pixels", pair.pixels},
                    {"pixel", {pair.i, pair.j}},
                    {"because", sentence(pair)}});
  }
  return json;
}

Json to_json(const Comparison& comparison, const ComparedAlgorithm& compared) {
  const exact::Errors& errors = compared.errors;
  const std::optional<double> per_million = errors_per_million(comparison, compared);
  Json json = {
      {"name", compared.algorithm.algorithm->name},
      {"settings", compared.algorithm.settings},
      {"wrong", errors.wrong},
      {"holes", errors.holes},
      {"leaks", errors.leaks},
      {"errors_per_million", per_million ? Json(*per_million) : Json()},
      {"other_of_tie", errors.other_of_tie},
      {"depth_error", nullptr},
      {"missing", nullptr},
      {"extra", nullptr},
      {"inversions", nullptr},
      {"color", nullptr},
      {"color_against", compared.algorithm.algorithm->traits.antialiased ? "32x32 samples" : "centres"},
      {"causes", causes(compared)},
      {"worst_pairs", worst_pairs(compared)},
      {"prepare_ms", compared.prepare_ms},
      {"time_ms", compared.render_ms},
  };
  if (errors.depth) json["depth_error"] = {{"max", errors.depth->max}, {"p99", errors.depth->p99}};
  if (compared.lists) {
    json["missing"] = compared.lists->missing;
    json["extra"] = compared.lists->extra;
    json["inversions"] = compared.lists->inversions;
  }
  if (errors.color) json["color"] = {{"rmse", errors.color->rmse}, {"max", errors.color->max}};
  return json;
}

}  // namespace

std::string to_json(const Comparison& comparison) {
  Json json = {
      {"scene", comparison.scene},
      {"triangles", comparison.triangles},
      {"width", comparison.width},
      {"height", comparison.height},
      {"covered", comparison.covered},
      {"decisions", {{"filtered", comparison.decisions.filtered}, {"integer", comparison.decisions.integer}}},
      {"exact_ms", comparison.exact_ms},
      {"algorithms", Json::array()},
  };
  for (const ComparedAlgorithm& compared : comparison.algorithms) {
    json["algorithms"].push_back(to_json(comparison, compared));
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace hsr
