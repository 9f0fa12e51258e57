#include "bench/cost_1974.h"

#include <algorithm>
#include <array>
#include <bit>
#include <nlohmann/json.hpp>

#include "bench/cell_runner.h"
#include "picture.h"
#include "scene/errors.h"
#include "text_layout.h"

namespace hsr::bench {
namespace {

using Json = nlohmann::ordered_json;

struct Method {
  std::string_view name;
  std::string_view algorithm;
};
constexpr std::array methods = {Method{"depth sort", "newell"}, Method{"z-buffer", "zbuffer"},
                                Method{"depth lists", "depthlist"}, Method{"ray casting", "raycast"}};

/// Comparisons that a sort of so many things takes at most, about.
std::uint64_t sort_comparisons(std::uint64_t count) {
  return count < 2 ? 0 : count * static_cast<std::uint64_t>(std::bit_width(count - 1));
}

/// Counts steps as operations.
void count(const Event& event, Cost1974& cost) {
  const auto add = [&](const char* name, std::uint64_t& sum, std::uint64_t operations = 1) {
    cost.operations[name] += operations;
    sum += operations;
  };
  switch (event.kind) {
    case EventKind::compared:
      add("pair tests", cost.on_faces);
      break;
    case EventKind::exchanged:
      add("exchanges", cost.on_faces);
      break;
    case EventKind::split:
      add("cuts", cost.on_faces);
      break;
    case EventKind::painted:
      add("pixels painted", cost.on_pixels);
      break;
    case EventKind::depth_tested:
      add("depth tests", cost.on_pixels);
      break;
    case EventKind::fragment_stored:
      add("fragments stored", cost.on_pixels);
      break;
    case EventKind::list_sorted:
      add("list comparisons", cost.on_pixels, sort_comparisons(event.number));
      break;
    case EventKind::node_entered:
    case EventKind::node_passed_by:
      add("box tests", cost.on_pixels);
      break;
    case EventKind::triangle_tested:
      add("triangle tests", cost.on_pixels);
      break;
    default:
      break;
  }
}

/// Every surface is kept, as the lists of 1974 do.
RenderOptions options_for(const Algorithm& algorithm, TimeLimit& limit) {
  RenderOptions options;
  options.progress = limit.progress();
  if (algorithm.name == "depthlist") options.skips_off.insert("hidden");
  return options;
}

void measure(const View& view, const Algorithm& algorithm, double most_seconds, Cost1974& cost) {
  TimeLimit limit(most_seconds);
  const RenderOptions options = options_for(algorithm, limit);
  limit.start();
  const Stopwatch preparing;
  const auto renderer =
      algorithm.prepare(*view.scene, parse_algorithm_spec(algorithm.name).settings, options);
  cost.prepare_ms = preparing.milliseconds();
  constexpr int repeats = 3;
  const Stopwatch all;
  for (int k = 0; k < repeats && all.milliseconds() < 1000.0; ++k) {
    Frame frame(view.width, view.height);
    limit.start();
    const Stopwatch stopwatch;
    (void)renderer->render(view, options, frame);
    limit.require_kept();
    const double ms = stopwatch.milliseconds();
    cost.render_ms = k == 0 ? ms : std::min(cost.render_ms, ms);
  }
  if (algorithm.name == "newell") {
    cost.on_faces = sort_comparisons(view.scene->triangles.size());
    cost.operations["key comparisons"] = cost.on_faces;
  }
  Frame frame(view.width, view.height);
  limit.start();
  (void)renderer->trace(
      view, options, [&](const Event& event) { count(event, cost); }, frame);
  limit.require_kept();
}

std::string relative(double value, double unit) { return unit > 0.0 ? significant(value / unit, 3) : ""; }

}  // namespace

std::vector<Cost1974> costs_of_1974(int faces, double most_seconds) {
  constexpr int depth = 4;
  const BenchScene scene = load_bench_scene(sheets_scene(faces, depth));
  PictureOptions options;
  options.size = {512, 512};
  const View view = choose_view(scene.scene, options);
  std::vector<Cost1974> costs;
  for (const Method& method : methods) {
    Cost1974 cost;
    cost.method = method.name;
    cost.algorithm = method.algorithm;
    cost.faces = faces;
    try {
      measure(view, *find_algorithm(method.algorithm), most_seconds, cost);
    } catch (const InputError& error) {
      cost = {method.name, method.algorithm, faces, {}, 0, 0, 0.0, 0.0, error.what()};
    }
    costs.push_back(cost);
  }
  return costs;
}

std::string to_json(const std::vector<Cost1974>& costs) {
  Json json = Json::array();
  for (const Cost1974& cost : costs) {
    json.push_back({{"method", cost.method},
                    {"algorithm", cost.algorithm},
                    {"faces", cost.faces},
                    {"operations", cost.operations},
                    {"on_faces", cost.on_faces},
                    {"on_pixels", cost.on_pixels},
                    {"prepare_ms", cost.prepare_ms},
                    {"render_ms", cost.render_ms},
                    {"failed", cost.failed}});
  }
  return json.dump();
}

std::vector<Cost1974> costs_from_json(std::string_view text) {
  try {
    std::vector<Cost1974> costs;
    for (const Json& json : Json::parse(text)) {
      const std::string name = json.at("algorithm");
      const auto* const method = std::ranges::find(methods, name, &Method::algorithm);
      if (method == methods.end()) throw InputError("\"" + name + "\" has no place in the table of 1974");
      Cost1974 cost = {method->name,        method->algorithm,    json.at("faces"),      {},
                       json.at("on_faces"), json.at("on_pixels"), json.at("prepare_ms"), json.at("render_ms"),
                       json.at("failed")};
      for (const auto& [operation, operations] : json.at("operations").items())
        cost.operations[operation] = operations;
      costs.push_back(cost);
    }
    return costs;
  } catch (const Json::exception& error) {
    throw InputError(std::string("no costs of hsr bench: ") + error.what());
  }
}

report::Table to_table(const std::vector<Cost1974>& costs) {
  report::Table table = {{"method", "algorithm", "faces", "operations on faces", "on pixels", "all",
                          "relative", "prepare ms", "render ms", "relative time"},
                         {}};
  double unit = 0.0;
  double unit_ms = 0.0;
  for (const Cost1974& cost : costs) {
    if (unit > 0.0 || cost.algorithm != methods.front().algorithm) continue;
    unit = static_cast<double>(cost.on_faces + cost.on_pixels);
    unit_ms = cost.render_ms;
  }
  for (const Cost1974& cost : costs) {
    std::vector<std::string> row = {std::string(cost.method), std::string(cost.algorithm),
                                    grouped(static_cast<std::uint64_t>(cost.faces))};
    if (!cost.failed.empty()) {
      row.push_back(cost.failed);
    } else {
      const std::uint64_t all = cost.on_faces + cost.on_pixels;
      row.insert(row.end(), {grouped(cost.on_faces), grouped(cost.on_pixels), grouped(all),
                             relative(static_cast<double>(all), unit), three_digits(cost.prepare_ms),
                             three_digits(cost.render_ms), relative(cost.render_ms, unit_ms)});
    }
    row.resize(table.heading.size());
    table.rows.push_back(row);
  }
  return table;
}

}  // namespace hsr::bench
