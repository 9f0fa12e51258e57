#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "algorithm.h"
#include "bench/bench_options.h"
#include "child_process.h"
#include "exercise/exercise_options.h"
#include "lesson/lesson_options.h"
#include "predicates/pixel_box.h"
#include "stress/stress_options.h"
#include "told_output.h"
#include "values.h"

namespace hsr {

/// The parts of a camera that the user chose; the rest comes from the scene.
struct CameraOptions {
  std::optional<glm::dvec3> eye;
  std::optional<glm::dvec3> target;
  std::optional<glm::dvec3> up;
  std::optional<double> vertical_fov_degrees;
};

/// What every subcommand that makes pictures is told.
struct PictureOptions {
  std::string scene;  ///< a built-in scene or a file
  Size size;
  CameraOptions camera;
  std::optional<double> near_depth;
  std::optional<double> far_depth;
  int threads = 1;
  std::vector<std::string> skips_off;  ///< names of skips, or "all"
};

struct RenderCommand {
  PictureOptions picture;
  AlgorithmSpec algorithm;
  std::optional<std::filesystem::path> png;
  std::optional<std::filesystem::path> layers;
  std::optional<std::filesystem::path> deep;
  std::optional<std::filesystem::path> statistics;
  std::optional<std::filesystem::path> stream;  ///< "-": standard output
  TellChoice tell;
  glm::vec3 backdrop{1.0F};  ///< linear RGB
  int repeats = 1;
};

struct CompareCommand {
  PictureOptions picture;
  std::vector<AlgorithmSpec> algorithms;
  std::optional<std::filesystem::path> json;
  std::optional<std::filesystem::path> heatmaps;  ///< a folder
};

/// A pixel of the picture: column and row from the upper left corner, from 0.
struct PixelPlace {
  int i = 0;
  int j = 0;
};

struct PixelCommand {
  PictureOptions picture;
  PixelPlace pixel;
  AlgorithmSpec algorithm;
  std::optional<std::filesystem::path> json;
};

struct TraceCommand {
  PictureOptions picture;
  AlgorithmSpec algorithm;
  std::optional<PixelBox> window;     ///< which pixels; all if not given
  std::optional<std::uint32_t> face;  ///< only steps about its triangles
  std::optional<std::uint64_t> from;  ///< steps are counted from 1
  std::optional<std::uint64_t> to;
  std::optional<std::filesystem::path> jsonl;
  std::optional<std::filesystem::path> gif;
  glm::vec3 backdrop{1.0F};  ///< linear RGB
};

struct ExportCommand {
  std::string scene;
  std::filesystem::path output;
};

struct ListCommand {
  enum class Catalogue { scenes, algorithms, settings };
  Catalogue catalogue = Catalogue::scenes;
  bool json = false;
};

struct ViewCommand {
  std::string scene;  ///< a scene or a state file; empty: where one left
  std::optional<AlgorithmSpec> algorithm;
  std::optional<std::filesystem::path> script;
  std::optional<std::string> picture_file;     ///< shows the picture that it tells
  std::optional<std::string> picture_command;  ///< or the one that this command writes for each view
  ChildLimits limits;                          ///< of the command
  int lesson = 0;                              ///< to be opened, from 1; 0: none
  int lesson_step = 1;
  std::optional<std::filesystem::path> watched;  ///< when it is saved the command is run again
  int threads = 1;
};

/// A text that was asked for instead of work, such as --help.
struct ShowText {
  std::string text;
};

/// What the user wants done.
using Command =
    std::variant<ShowText, ViewCommand, RenderCommand, CompareCommand, PixelCommand, TraceCommand,
                 ExportCommand, BenchCommand, StressCommand, ListCommand, LessonCommand, ExerciseCommand>;

}  // namespace hsr
