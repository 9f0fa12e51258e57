#include <algorithm>
#include <ostream>

#include "commands/commands.h"
#include "comparison.h"
#include "exact/exact_colors.h"
#include "exact/sampled_colors.h"
#include "heatmaps.h"
#include "lists_by_rows.h"
#include "output_file.h"
#include "picture.h"
#include "scene/atomic_file.h"
#include "skip_choice.h"

namespace hsr {
namespace {

/// The exact answer of a view, and what was needed to find it.
struct Truth {
  exact::ExactAnswer answer;
  exact::Nearest nearest;
  std::vector<glm::vec4> colors;
  std::vector<glm::vec4> mean_colors;  ///< of 32 × 32 samples, where an algorithm antialiases

  Truth(const View& view, bool antialiased, int threads, const Progress& progress)
      : answer(view, threads, progress),
        nearest(answer.nearest(threads, progress)),
        colors(exact::exact_colors(view, answer, nearest, threads, progress)) {
    if (antialiased) mean_colors = exact::sampled_colors(view, threads, progress);
  }
};

/// Renders once more, with lists, and counts their errors.
exact::ListErrors list_errors(Renderer& renderer, const View& view, const RenderOptions& options,
                              const Truth& truth) {
  exact::ListErrors errors;
  render_lists_by_rows(renderer, view, options, "comparing the lists",
                       [&](const FragmentLists& lists, int first, int rows) {
                         errors += exact::measure_list_errors(lists, truth.answer, view.width,
                                                              {first, first + rows}, options.threads);
                       });
  return errors;
}

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
  compared.errors = exact::measure_errors(frame, truth.answer, truth.nearest,
                                          traits.antialiased ? truth.mean_colors : truth.colors);
  OrderingFailures failures =
      find_failures(view, spec, options, frame, truth.answer, truth.nearest, truth.colors);
  compared.causes = failures.pixels;
  if (heatmaps) write_algorithm_heatmaps(view, spec, frame, failures, options, *heatmaps);
  constexpr std::size_t most_pairs = 3;
  failures.pairs.resize(std::min(failures.pairs.size(), most_pairs));
  compared.worst_pairs = std::move(failures.pairs);
  if (traits.keeps_lists) compared.lists = list_errors(*renderer, view, options, truth);
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
