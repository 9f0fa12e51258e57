#include "picture.h"

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "frame/frame.h"
#include "nearest_name.h"
#include "scene/catalog.h"
#include "scene/errors.h"
#include "text_layout.h"

namespace hsr {
namespace {

/// More warnings than anybody reads are counted instead.
constexpr std::size_t most_warnings = 20;

void print_warnings(const std::vector<std::string>& warnings) {
  for (std::size_t k = 0; k < warnings.size() && k < most_warnings; ++k) {
    std::cerr << "warning: " << warnings[k] << "\n";
  }
  if (warnings.size() > most_warnings) {
    std::cerr << "warning: and " << grouped(warnings.size() - most_warnings) << " more warnings\n";
  }
}

/// Throws UsageError if `name` is neither a built-in scene nor looks like the name of a file.
void require_file_name(const std::string& name) {
  std::error_code ignored;
  if (name.find_first_of("./") != std::string::npos || std::filesystem::exists(name, ignored)) return;
  std::vector<std::string_view> names;
  for (const SceneEntry& entry : scene_catalog()) names.push_back(entry.name);
  throw UsageError("SCENE: \"" + name + "\" is neither a file nor a built-in scene" +
                   what_there_is(name, names));
}

/// A picture takes its frame, and about as much again while it is made and written. Asking the
/// system for more than it has would get the program killed without a word.
void require_memory(Size size) {
  constexpr double bytes_per_pixel = sizeof(glm::vec4) + sizeof(float) + sizeof(std::uint32_t);
  const double needed = bytes_per_pixel * size.width * size.height;
  const double present =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (present <= 0.0 || 2.0 * needed <= present) return;
  constexpr double gigabyte = 1e9;
  throw InputError("--size: a picture of " + std::to_string(size.width) + "x" + std::to_string(size.height) +
                   " pixels needs about " + significant(2.0 * needed / gigabyte, 2) +
                   " GB of memory; this machine has " + significant(present / gigabyte, 2) + " GB");
}

}  // namespace

Scene open_scene(const std::string& name, ReadReport& report, const Progress& progress) {
  if (name.find('/') == std::string::npos) {
    if (std::optional<Scene> built_in = make_built_in_scene(name)) return std::move(*built_in);
  }
  require_file_name(name);
  return read_scene(name, report, progress);
}

LoadedScene load_scene(const std::string& name, ProgressBar& bar) {
  const Stopwatch stopwatch;
  LoadedScene loaded;
  ReadReport report;
  loaded.scene = open_scene(name, report, bar.listener());
  loaded.warnings = report.warnings.size();
  bar.erase();
  print_warnings(report.warnings);
  loaded.milliseconds = stopwatch.milliseconds();
  return loaded;
}

View choose_view(const Scene& scene, const PictureOptions& options) {
  require_memory(options.size);
  const double aspect = static_cast<double>(options.size.width) / options.size.height;
  Camera camera = scene.camera ? *scene.camera : framing_camera(scene, aspect);
  const CameraOptions& given = options.camera;
  camera.eye = given.eye.value_or(camera.eye);
  camera.target = given.target.value_or(camera.target);
  camera.up = given.up.value_or(camera.up);
  camera.vertical_fov_degrees = given.vertical_fov_degrees.value_or(camera.vertical_fov_degrees);
  return make_view(scene, camera, options.size.width, options.size.height, options.near_depth,
                   options.far_depth);
}

}  // namespace hsr
