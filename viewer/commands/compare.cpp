#include <algorithm>
#include <ostream>

#include "commands/commands.h"
#include "comparison.h"
#include "heatmaps.h"
#include "output_file.h"
#include "picture.h"
#include "scene/atomic_file.h"
#include "skip_choice.h"
#include "truth.h"

namespace hsr {
namespace {

ComparedAlgorithm compare_one(const AlgorithmSpec& spec, const View& view, const RenderOptions& options,
                              const Truth& truth, const std::optional<std::filesystem::path>& heatmaps) {
  ComparedAlgorithm compared;
  compared.algorithm = spec;
  const Stopwatch prepare;
  const auto renderer = spec.algorithm->prepare(*view.scene, spec.settings, options);
  compared.prepare_ms = prepare.milliseconds();
  Frame frame(view.width, view.height);
  const Stopwatch render;
  (void)renderer->render(view, options, frame);
  compared.render_ms = render.milliseconds();
  const Traits& traits = spec.algorithm->traits;
  compared.errors =
      exact::measure_errors(frame, truth.answer, truth.nearest, truth.wanted_colors(*spec.algorithm));
  OrderingFailures failures =
      find_failures(view, spec, options, frame, truth.answer, truth.nearest, truth.colors);
  compared.causes = failures.pixels;
  if (heatmaps) write_algorithm_heatmaps(view, spec, frame, failures, options, *heatmaps);
  constexpr std::size_t most_pairs = 3;
  failures.pairs.resize(std::min(failures.pairs.size(), most_pairs));
  compared.worst_pairs = std::move(failures.pairs);
  if (traits.keeps_lists) compared.lists = measure_lists(*renderer, view, options, truth);
  return compared;
}

}  // namespace

void run(const CompareCommand& command, std::ostream& out) {
  if (command.json) require_place(*command.json);
  if (command.heatmaps) make_folder(*command.heatmaps);
  const PictureOptions& picture = command.picture;
  ProgressBar bar;
  const LoadedScene loaded = load_scene(picture.scene, bar);
  const View view = choose_view(loaded.scene, picture);

  const Stopwatch stopwatch;
  const bool antialiased = std::ranges::any_of(
      command.algorithms, [](const AlgorithmSpec& spec) { return spec.algorithm->traits.antialiased; });
  const Truth truth(view, antialiased, picture.threads, bar.listener());
  Comparison comparison = {
      loaded.scene.name,       loaded.scene.triangles.size(), view.width, view.height, truth.nearest.covered,
      truth.nearest.decisions, stopwatch.milliseconds(),      {}};
  if (command.heatmaps) {
    write_scene_heatmaps(view, truth.answer, truth.nearest, {picture.threads, {}, bar.listener()},
                         *command.heatmaps);
  }
  const auto skips_off = chosen_skips(picture.skips_off, command.algorithms);
  for (const AlgorithmSpec& spec : command.algorithms) {
    const RenderOptions options = {picture.threads, skips_off, bar.listener(spec.text())};
    comparison.algorithms.push_back(compare_one(spec, view, options, truth, command.heatmaps));
  }
  bar.erase();
  if (command.json) {
    write_file_atomically(*command.json, [&](const std::filesystem::path& temporary) {
      write_bytes(temporary, to_json(comparison));
    });
  }
  out << to_text(comparison);
  if (command.json) out << "\nWrote " << command.json->string() << ".\n";
  if (command.heatmaps) out << "\nWrote pictures into " << command.heatmaps->string() << ".\n";
}

}  // namespace hsr
