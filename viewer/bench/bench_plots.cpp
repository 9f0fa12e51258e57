#include "bench/bench_plots.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "bench/peers.h"
#include "text_layout.h"

namespace hsr::bench {
namespace {

using report::Look;
using report::Panel;
using report::Point;
using report::Series;

/// Textbook versions are open marks, fast ones the same filled, peers black.
Look look_of(const RunRecord& run) {
  constexpr std::array families = {"zbuffer", "newell", "raycast", "painter", "abuffer", "depthlist"};
  constexpr std::array<unsigned, 6> colors = {0, 2, 6, 1, 4, 5};
  constexpr unsigned open = 6;
  constexpr unsigned cross = 12;
  constexpr unsigned black = 3;
  if (run.peer) {
    const auto peers = peer_table();
    return {black,
            static_cast<unsigned>(std::ranges::find(peers, run.name, &PeerEntry::name) - peers.begin())};
  }
  const bool fast = run.algorithm.ends_with("-fast");
  for (std::size_t k = 0; k < families.size(); ++k) {
    if (run.algorithm.starts_with(families[k]))
      return {colors[k], static_cast<unsigned>(k) + (fast ? 0U : open)};
  }
  return {black, cross};
}

/// A look for each of several scenes.
Look scene_look(std::size_t place) { return {static_cast<unsigned>(place), static_cast<unsigned>(place)}; }

/// What stands between the brackets of a name; nothing for the defaults.
std::string settings_of(const RunRecord& run) {
  const std::size_t bracket = run.name.find('[');
  return bracket == std::string::npos ? "" : run.name.substr(bracket + 1, run.name.size() - bracket - 2);
}

std::string legend_name(const RunRecord& run) { return run.peer ? run.name : run.algorithm; }

Series& series_called(std::vector<Series>& all, const std::string& name, Look look) {
  const auto found = std::ranges::find(all, name, &Series::name);
  return found != all.end() ? *found : all.emplace_back(Series{name, look, {}});
}

report::Spread middle_half(const Timing& timing) { return {timing.at(0.25), timing.at(0.75)}; }

std::string size_text(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

/// The scene's name as part of a file's.
std::string file_name(const std::string& scene) {
  std::string name = std::filesystem::path(scene).filename().string();
  std::ranges::replace_if(
      name, [](unsigned char letter) { return std::isalnum(letter) == 0; }, '-');
  return name;
}

std::string scene_label(const RunRecord& run) {
  return std::filesystem::path(run.scene).filename().string() + " " + size_text(run.width, run.height);
}

std::string law_text(const Growth& growth) {
  const char* const letter = growth.runs.front()->question == Question::triangles ? "n"
                             : growth.runs.front()->question == Question::pixels  ? "p"
                                                                                  : "d";
  return growth.law ? growth.name + ": " + letter + "^" + significant(growth.law->exponent, 2) : growth.name;
}

}  // namespace

DescribedPlot tradeoff_plot(const Tradeoff& tradeoff) {
  const std::string scene = std::filesystem::path(tradeoff.scene).filename().string();
  Panel panel = {
      "", {"time of a picture (ms, median)", true}, {"wrong pixels per million covered", true}, {}};
  Series front = {"not beaten in both", {3, 0}, {}, false, true, true};
  for (const RunRecord* run : tradeoff.front)
    front.points.push_back(
        {run->render.median(), run->errors_per_million().value_or(0.0), {}, {}, run->name});
  panel.series.push_back(front);
  std::vector<Series> algorithms;
  for (const RunRecord* run : tradeoff.runs) {
    const bool on_front = std::ranges::find(tradeoff.front, run) != tradeoff.front.end();
    series_called(algorithms, legend_name(*run), look_of(*run))
        .points.push_back({run->render.median(),
                           run->errors_per_million().value_or(0.0),
                           middle_half(run->render),
                           {},
                           on_front || run->wrong_pixels() == 0 ? "" : settings_of(*run)});
  }
  panel.series.insert(panel.series.end(), algorithms.begin(), algorithms.end());
  DescribedPlot plot;
  plot.plot.name = "tradeoff-" + file_name(tradeoff.scene) + "-" + size_text(tradeoff.width, tradeoff.height);
  plot.plot.title =
      "Time against error: " + scene + ", " + size_text(tradeoff.width, tradeoff.height) + ", " +
      (tradeoff.runs.empty() ? ""
                             : counted(static_cast<std::uint64_t>(tradeoff.runs.front()->threads), "thread"));
  plot.plot.panels = {panel};
  plot.says = "Time against wrong pixels on " + scene + " for every algorithm and setting.";
  return plot;
}

DescribedPlot growth_plot(const std::vector<RunRecord>& runs, Question question) {
  DescribedPlot plot;
  const std::vector<Growth> all = growths(runs, question);
  if (all.empty()) return plot;
  const char* const what = question == Question::triangles ? "triangles"
                           : question == Question::pixels  ? "pixels"
                                                           : "surfaces at every pixel";
  plot.plot.name = std::string("growth-") + std::string(name_of(question));
  plot.plot.title = std::string("Growth of time with the number of ") + what;
  Panel panel = {"", {std::string("number of ") + what, true}, {"time of a picture (ms, median)", true}, {}};
  for (const Growth& growth : all) {
    Series series = {law_text(growth), look_of(*growth.runs.front()), {}, true, true};
    // A second structure of one algorithm has its colour, and a broken line.
    series.dashed = !settings_of(*growth.runs.front()).empty();
    for (const RunRecord* run : growth.runs)
      series.points.push_back({run->parameter, run->render.median(), {}, middle_half(run->render)});
    panel.series.push_back(series);
  }
  plot.plot.panels = {panel};
  plot.says = plot.plot.title + ", both on logarithmic axes; the exponent of each is in the legend.";
  return plot;
}

DescribedPlot skip_plot(const std::vector<RunRecord>& runs) {
  DescribedPlot plot;
  const std::vector<SkipGain> gains = skip_gains(runs);
  std::map<std::string, double> most;
  for (const SkipGain& gain : gains) {
    const std::string row = gain.with->name + " without " + gain.without->skip_off;
    most[row] = std::max(most[row], gain.times);
  }
  std::vector<std::pair<double, std::string>> rows;
  for (const auto& [row, times] : most) rows.emplace_back(times, row);
  std::ranges::sort(rows, std::greater());
  constexpr std::size_t most_rows = 16;
  rows.resize(std::min(rows.size(), most_rows));
  if (rows.empty()) return plot;
  Panel panel = {"", {"times as long without the skip", true}, {"", false, {}}, {}};
  for (const auto& [times, row] : rows) panel.y.categories.push_back(row);
  std::vector<std::string> scenes;
  for (const SkipGain& gain : gains) {
    const auto row =
        std::ranges::find(panel.y.categories, gain.with->name + " without " + gain.without->skip_off);
    if (row == panel.y.categories.end()) continue;
    const std::string scene = scene_label(*gain.with);
    if (std::ranges::find(scenes, scene) == scenes.end()) scenes.push_back(scene);
    const auto place = static_cast<std::size_t>(std::ranges::find(scenes, scene) - scenes.begin());
    series_called(panel.series, scene, scene_look(place))
        .points.push_back({gain.times, static_cast<double>(row - panel.y.categories.begin()),
                           report::Spread{gain.low, gain.high}});
  }
  plot.plot = {"skips", "What each skip saves", {panel}};
  plot.says = "How many times as long each algorithm takes without one of its skips, by scene.";
  return plot;
}

std::vector<const RunRecord*> structure_runs(const std::vector<RunRecord>& runs) {
  std::vector<const RunRecord*> chosen;
  for (const Tradeoff& tradeoff : tradeoffs(runs)) {
    for (const RunRecord* run : tradeoff.runs) {
      if (!run->peer && run->algorithm.starts_with("raycast") && run->name.find("test=") == std::string::npos)
        chosen.push_back(run);
    }
  }
  return chosen;
}

DescribedPlot structure_plot(const std::vector<RunRecord>& runs) {
  DescribedPlot plot;
  const std::vector<const RunRecord*> chosen = structure_runs(runs);
  if (chosen.empty()) return plot;
  constexpr double megabyte = 1e6;
  std::vector<Panel> panels = {{"Build", {"time (ms)", true}, {}, {}},
                               {"Memory", {"megabytes", true}, {}, {}},
                               {"Trace", {"time of a picture (ms, median)", true}, {}, {}}};
  std::vector<std::string> names;
  std::vector<std::string> scenes;
  for (const RunRecord* run : chosen) {
    if (std::ranges::find(names, run->name) == names.end()) names.push_back(run->name);
    const std::string scene = scene_label(*run);
    if (std::ranges::find(scenes, scene) == scenes.end()) scenes.push_back(scene);
    const auto row = static_cast<double>(std::ranges::find(names, run->name) - names.begin());
    const auto look = scene_look(static_cast<std::size_t>(std::ranges::find(scenes, scene) - scenes.begin()));
    const std::array values = {run->prepare_ms, static_cast<double>(run->bytes) / megabyte,
                               run->render.median()};
    for (std::size_t k = 0; k < values.size(); ++k)
      series_called(panels[k].series, scene, look).points.push_back({values[k], row});
  }
  for (Panel& panel : panels) panel.y.categories = names;
  plot.plot = {"structures", "Structures of ray casting", panels};
  plot.says = "Build time, memory and time of a picture for each structure of ray casting, by scene.";
  return plot;
}

DescribedPlot plot_of_1974(const std::vector<Cost1974>& costs) {
  DescribedPlot plot;
  if (costs.empty()) return plot;
  std::vector<Panel> panels = {{"Operations", {"number of faces", true}, {"operations", true}, {}},
                               {"Time", {"number of faces", true}, {"time of a picture (ms)", true}, {}}};
  for (const Cost1974& cost : costs) {
    if (!cost.failed.empty()) continue;
    RunRecord run;
    run.algorithm = cost.algorithm;
    const std::array values = {static_cast<double>(cost.on_faces + cost.on_pixels), cost.render_ms};
    for (std::size_t k = 0; k < values.size(); ++k) {
      Series& series = series_called(panels[k].series, std::string(cost.method), look_of(run));
      series.line = true;
      series.points.push_back({static_cast<double>(cost.faces), values[k]});
    }
  }
  plot.plot = {"table-1974", "The table of 1974, counted and timed today", panels, 2};
  plot.says = "Operations and time of four methods over the number of faces.";
  return plot;
}

}  // namespace hsr::bench
