#include <algorithm>
#include <limits>
#include <memory>
#include <ostream>
#include <string>

#include "commands/commands.h"
#include "frame/deep_image.h"
#include "frame/write_image.h"
#include "frame/write_svg.h"
#include "lists_by_rows.h"
#include "output_file.h"
#include "picture.h"
#include "scene/atomic_file.h"
#include "scene/errors.h"
#include "skip_choice.h"
#include "statistics.h"
#include "text_layout.h"
#include "told_output.h"
#include "view/shading.h"

namespace hsr {
namespace {

/// Throws UsageError unless a deep image can be made of what the algorithm keeps.
void require_lists(const RenderCommand& command) {
  require_ending("--deep", *command.deep, {".exr"});
  if (command.algorithm.algorithm->traits.keeps_lists) return;
  std::string names;
  for (const Algorithm* algorithm : algorithm_catalog()) {
    if (algorithm->traits.keeps_lists) names.append(names.empty() ? "" : ", ").append(algorithm->name);
  }
  throw UsageError("--deep: " + std::string(command.algorithm.algorithm->name) +
                   " keeps no depth lists; those that do: " + names);
}

bool is_vector(const std::optional<std::filesystem::path>& file) {
  if (!file) return false;
  const std::string ending = file->extension().string();
  return ending == ".svg" || ending == ".SVG";
}

/// Throws UsageError unless vector graphics can be made of what the algorithm paints.
void require_faces(const RenderCommand& command) {
  if (command.algorithm.algorithm->traits.paints_faces) return;
  std::string names;
  for (const Algorithm* algorithm : algorithm_catalog()) {
    if (algorithm->traits.paints_faces) names.append(names.empty() ? "" : ", ").append(algorithm->name);
  }
  throw UsageError("--output: " + std::string(command.algorithm.algorithm->name) +
                   " paints no whole faces, so there is no .svg of them; those that do: " + names);
}

void check_outputs(const RenderCommand& command) {
  for (const auto& file : {command.png, command.layers, command.deep, command.statistics}) {
    if (file) require_place(*file);
  }
  if (command.stream && command.stream != "-") require_place(*command.stream);
  if ((command.tell.lists || command.tell.steps) && !command.stream)
    throw UsageError("--tell says what --stream tells, which is not given");
  if (command.png) require_ending("--output", *command.png, {".png", ".svg"});
  if (is_vector(command.png)) require_faces(command);
  if (command.layers) require_ending("--layers", *command.layers, {".exr"});
  if (command.deep) require_lists(command);
  if (command.deep && command.deep == command.layers) {
    throw UsageError("--deep: \"" + command.deep->string() + "\" is the name of the layers already");
  }
  if (command.statistics && (command.statistics == command.png || command.statistics == command.layers ||
                             command.statistics == command.deep)) {
    throw UsageError("--stats: \"" + command.statistics->string() + "\" is the name of an image already");
  }
}

/// Renders the view `repeats` times, each time into a frame of its own. Only rendering is timed.
RenderReport render_repeatedly(Renderer& renderer, const View& view, const RenderOptions& options,
                               int repeats, bool faces, Frame& frame, double& least_ms) {
  RenderReport report;
  least_ms = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < repeats; ++repeat) {
    frame = Frame();  // gives the memory back before as much is taken again
    frame = Frame(view.width, view.height);
    if (faces) frame.faces.emplace();
    const Stopwatch stopwatch;
    report = renderer.render(view, options, frame);
    least_ms = std::min(least_ms, stopwatch.milliseconds());
  }
  return report;
}

/// Renders once more, with lists, and writes them.
void write_deep(const RenderCommand& command, Renderer& renderer, const View& view,
                const RenderOptions& options) {
  const std::vector<glm::vec4> colors = surface_colors(*view.scene, options.threads);
  DeepImage image(view.width, view.height, colors);
  render_lists_by_rows(
      renderer, view, options, "writing the lists",
      [&](const FragmentLists& lists, int first, int rows) { image.add_rows(lists, first, rows); });
  image.write(*command.deep);
}

void write_files(const RenderCommand& command, const Frame& frame, const Statistics& statistics,
                 const Progress& progress) {
  if (frame.faces) {
    write_svg(*frame.faces, frame.width, frame.height, command.backdrop, *command.png, progress);
  } else if (command.png) {
    write_png(frame, command.backdrop, *command.png, progress);
  }
  if (command.layers) write_exr_layers(frame, *command.layers, progress);
  if (command.statistics) {
    write_file_atomically(*command.statistics, [&](const std::filesystem::path& temporary) {
      write_bytes(temporary, to_json(statistics));
    });
  }
}

void print_summary(const RenderCommand& command, const Statistics& statistics, std::ostream& out) {
  const View& view = *statistics.view;
  out << view.scene->name << ", " << statistics.algorithm->text() << ": " << view.width << "x" << view.height
      << ", " << counted(view.scene->triangles.size(), "triangle") << "; load "
      << milliseconds(statistics.load_ms) << ", prepare " << milliseconds(statistics.prepare_ms)
      << ", render " << milliseconds(statistics.render_ms);
  const char* separator = "; wrote ";
  for (const auto& file : {command.png, command.layers, command.deep, command.statistics, command.stream}) {
    if (!file) continue;
    out << separator << file->string();
    separator = ", ";
  }
  out << "\n";
}

/// What the algorithm did and left out, by name; work on rays also per ray.
void print_work(const RenderReport& report, std::ostream& out) {
  const auto rays = report.counters.find("rays");
  std::string work = "bytes " + grouped(report.bytes);
  for (const auto& [name, count] : report.counters) {
    work += ", " + name + " " + grouped(count);
    const bool per_ray = name == "structure_steps" || name == "triangle_tests";
    if (rays != report.counters.end() && rays->second > 0 && per_ray) {
      work += " (" + three_digits(static_cast<double>(count) / static_cast<double>(rays->second)) + " a ray)";
    }
  }
  std::string skipped;
  for (const auto& [name, count] : report.skipped) {
    skipped += (skipped.empty() ? "" : ", ") + name + " " + grouped(count);
  }
  out << definition("work", work, 2, 12);
  if (!skipped.empty()) out << definition("skipped", skipped, 2, 12);
}

}  // namespace

void run(const RenderCommand& command, std::ostream& out) {
  check_outputs(command);
  ProgressBar bar;
  const LoadedScene loaded = load_scene(command.picture.scene, bar);
  const View view = choose_view(loaded.scene, command.picture);
  const RenderOptions options = {command.picture.threads,
                                 chosen_skips(command.picture.skips_off, {&command.algorithm, 1}),
                                 bar.listener()};
  const Stopwatch stopwatch;
  const auto renderer =
      command.algorithm.algorithm->prepare(loaded.scene, command.algorithm.settings, options);
  const double prepare_ms = stopwatch.milliseconds();

  Frame frame;
  double render_ms = 0.0;
  const RenderReport report =
      render_repeatedly(*renderer, view, options, command.repeats, is_vector(command.png), frame, render_ms);

  const Statistics statistics = {
      &command.algorithm,  &view,      &report,  loaded.warnings, command.picture.threads, command.repeats,
      loaded.milliseconds, prepare_ms, render_ms};
  if (command.deep) write_deep(command, *renderer, view, options);
  write_files(command, frame, statistics, bar.listener());
  if (command.stream) {
    const ToldPicture told = tell_picture(view, command.algorithm, *renderer, options, frame, command.tell);
    write_told_picture(told, *command.stream, out);
  }
  bar.erase();
  if (command.stream == "-") return;  // whoever reads the picture can do without words
  print_summary(command, statistics, out);
  print_work(report, out);
}

}  // namespace hsr
