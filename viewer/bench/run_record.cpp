#include "bench/run_record.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "scene/errors.h"

namespace hsr::bench {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const exact::Errors& errors) {
  Json json = {{"wrong", errors.wrong},  {"holes", errors.holes},
               {"leaks", errors.leaks},  {"other_of_tie", errors.other_of_tie},
               {"depth_error", nullptr}, {"color", nullptr}};
  if (errors.depth) json["depth_error"] = {{"max", errors.depth->max}, {"p99", errors.depth->p99}};
  if (errors.color) json["color"] = {{"rmse", errors.color->rmse}, {"max", errors.color->max}};
  return json;
}

/// JSON has no infinity and writes null for it.
double number(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

exact::Errors errors_of(const Json& json) {
  exact::Errors errors;
  errors.wrong = json.at("wrong");
  errors.holes = json.at("holes");
  errors.leaks = json.at("leaks");
  errors.other_of_tie = json.at("other_of_tie");
  if (const Json& depth = json.at("depth_error"); !depth.is_null())
    errors.depth = {number(depth.at("max")), number(depth.at("p99"))};
  if (const Json& color = json.at("color"); !color.is_null())
    errors.color = {number(color.at("rmse")), number(color.at("max"))};
  return errors;
}

/// "hidden=12 off-screen=3"
std::string joined(const std::map<std::string, std::uint64_t, std::less<>>& counts) {
  std::string text;
  for (const auto& [name, count] : counts)
    text += (text.empty() ? "" : " ") + name + "=" + std::to_string(count);
  return text;
}

void add_error_cells(const RunRecord& record, std::vector<std::string>& row) {
  const std::optional<exact::Errors>& errors = record.errors;
  const auto count = [&](std::uint64_t exact::Errors::*member) {
    return errors ? std::to_string((*errors).*member) : "";
  };
  row.insert(row.end(), {count(&exact::Errors::wrong), count(&exact::Errors::holes),
                         count(&exact::Errors::leaks), count(&exact::Errors::other_of_tie)});
  const std::optional<double> per_million = record.errors_per_million();
  row.push_back(per_million ? report::number_text(*per_million) : "");
  if (errors && errors->depth)
    row.insert(row.end(), {report::number_text(errors->depth->max), report::number_text(errors->depth->p99)});
  else
    row.insert(row.end(), 2, "");
  if (errors && errors->color)
    row.insert(row.end(),
               {report::number_text(errors->color->rmse), report::number_text(errors->color->max)});
  else
    row.insert(row.end(), 2, "");
  row.push_back(record.lists ? std::to_string(record.lists->missing) : "");
  row.push_back(record.lists ? std::to_string(record.lists->extra) : "");
  row.push_back(record.lists ? std::to_string(record.lists->inversions) : "");
}

std::vector<std::string> row_of(const RunRecord& record) {
  std::vector<std::string> row = {std::string(name_of(record.question)),
                                  record.scene,
                                  std::to_string(record.triangles),
                                  std::to_string(record.width),
                                  std::to_string(record.height),
                                  std::to_string(record.covered),
                                  record.name,
                                  record.peer ? "yes" : "no",
                                  std::to_string(record.threads),
                                  record.skip_off,
                                  record.failed};
  const bool ran = !record.render.ms.empty();
  row.push_back(ran ? report::number_text(record.load_ms) : "");
  row.push_back(ran ? report::number_text(record.prepare_ms) : "");
  for (const double share : {0.0, 0.25, 0.5, 0.75})
    row.push_back(ran ? report::number_text(record.render.at(share)) : "");
  row.push_back(std::to_string(record.render.ms.size()));
  row.push_back(record.settled ? "yes" : "no");
  row.push_back(ran && !record.peer ? std::to_string(record.bytes) : "");
  add_error_cells(record, row);
  row.push_back(joined(record.skipped));
  row.push_back(joined(record.counters));
  return row;
}

}  // namespace

std::string RunRecord::key() const {
  return std::string(name_of(question)) + " | " + scene + " | " + std::to_string(width) + "x" +
         std::to_string(height) + " | " + name + " | " + std::to_string(threads) +
         (skip_off.empty() ? "" : " | without " + skip_off);
}

std::uint64_t RunRecord::wrong_pixels() const {
  return errors ? errors->wrong + errors->holes + errors->leaks : 0;
}

std::optional<double> RunRecord::errors_per_million() const {
  if (!errors || covered == 0) return std::nullopt;
  return 1e6 * static_cast<double>(wrong_pixels()) / static_cast<double>(covered);
}

std::string to_json(const RunRecord& record) {
  Json json = {{"question", name_of(record.question)},
               {"scene", record.scene},
               {"triangles", record.triangles},
               {"width", record.width},
               {"height", record.height},
               {"covered", record.covered},
               {"parameter", record.parameter},
               {"name", record.name},
               {"algorithm", record.algorithm},
               {"peer", record.peer},
               {"only_geometry", record.only_geometry},
               {"threads", record.threads},
               {"skip_off", record.skip_off},
               {"failed", record.failed},
               {"load_ms", record.load_ms},
               {"prepare_ms", record.prepare_ms},
               {"least_ms", record.render.least()},
               {"median_ms", record.render.median()},
               {"quarter_below_ms", record.render.at(0.25)},
               {"quarter_above_ms", record.render.at(0.75)},
               {"ms", record.render.ms},
               {"settled", record.settled},
               {"bytes", record.bytes},
               {"skipped", record.skipped},
               {"counters", record.counters},
               {"errors", nullptr},
               {"errors_per_million", nullptr},
               {"lists", nullptr}};
  if (record.errors) json["errors"] = json_of(*record.errors);
  if (const std::optional<double> share = record.errors_per_million()) json["errors_per_million"] = *share;
  if (record.lists)
    json["lists"] = {{"missing", record.lists->missing},
                     {"extra", record.lists->extra},
                     {"inversions", record.lists->inversions}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

RunRecord record_from_json(std::string_view text) {
  try {
    const Json json = Json::parse(text);
    RunRecord record;
    const std::string question = json.at("question");
    const auto* const found = std::ranges::find(question_names, question);
    if (found == std::end(question_names))
      throw InputError("\"" + question + "\" is no question of hsr bench");
    record.question = static_cast<Question>(found - std::begin(question_names));
    record.scene = json.at("scene");
    record.triangles = json.at("triangles");
    record.width = json.at("width");
    record.height = json.at("height");
    record.covered = json.at("covered");
    record.parameter = json.at("parameter");
    record.name = json.at("name");
    record.algorithm = json.at("algorithm");
    record.peer = json.at("peer");
    record.only_geometry = json.at("only_geometry");
    record.threads = json.at("threads");
    record.skip_off = json.at("skip_off");
    record.failed = json.at("failed");
    record.load_ms = json.at("load_ms");
    record.prepare_ms = json.at("prepare_ms");
    record.render.ms = json.at("ms").get<std::vector<double>>();
    record.settled = json.at("settled");
    record.bytes = json.at("bytes");
    for (const auto& [name, count] : json.at("skipped").items()) record.skipped[name] = count;
    for (const auto& [name, count] : json.at("counters").items()) record.counters[name] = count;
    if (!json.at("errors").is_null()) record.errors = errors_of(json.at("errors"));
    if (const Json& lists = json.at("lists"); !lists.is_null())
      record.lists = exact::ListErrors{lists.at("missing"), lists.at("extra"), lists.at("inversions")};
    return record;
  } catch (const Json::exception& error) {
    throw InputError(std::string("no run of hsr bench: ") + error.what());
  }
}

report::Table to_table(const std::vector<RunRecord>& records) {
  report::Table table = {{"question",
                          "scene",
                          "triangles",
                          "width",
                          "height",
                          "covered",
                          "algorithm",
                          "peer",
                          "threads",
                          "without",
                          "failed",
                          "load_ms",
                          "prepare_ms",
                          "least_ms",
                          "quarter_ms",
                          "median_ms",
                          "three_quarters_ms",
                          "runs",
                          "settled",
                          "bytes",
                          "wrong",
                          "holes",
                          "leaks",
                          "other_of_tie",
                          "errors_per_million",
                          "depth_error_max",
                          "depth_error_p99",
                          "color_rmse",
                          "color_max",
                          "missing",
                          "extra",
                          "inversions",
                          "skipped",
                          "counters"},
                         {}};
  for (const RunRecord& record : records) table.rows.push_back(row_of(record));
  return table;
}

}  // namespace hsr::bench
