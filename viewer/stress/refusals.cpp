#include "stress/refusals.h"

#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>

#include "scene/errors.h"
#include "scene/read_scene.h"
#include "view/view.h"

namespace hsr::stress {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A file that goes when it is no longer needed.
class TemporaryFile {
 public:
  TemporaryFile(std::string_view ending, std::string_view content)
      : file_(std::filesystem::temp_directory_path() /
              ("hsr-stress-" + std::to_string(getpid()) + std::string(ending))) {
    std::ofstream(file_, std::ios::binary) << content;
  }
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::filesystem::path& path() const { return file_; }
  /// `message` without the folder.
  std::string plain(std::string message) const {
    const std::string folder = file_.parent_path().string() + "/";
    for (std::size_t at = message.find(folder); at != std::string::npos; at = message.find(folder)) {
      message.erase(at, folder.size());
    }
    return message;
  }

 private:
  std::filesystem::path file_;
};

bool is_finite(const Scene& scene) {
  for (const glm::vec3& position : scene.positions) {
    if (!std::isfinite(position.x) || !std::isfinite(position.y) || !std::isfinite(position.z)) return false;
  }
  return true;
}

Refusal of_file(std::string what, std::string_view ending, std::string_view content) {
  Refusal refusal = {std::move(what), ""};
  const TemporaryFile file(ending, content);
  try {
    ReadReport report;
    const Scene scene = read_scene(file.path(), report);
    if (is_finite(scene) && !report.warnings.empty()) refusal.said = file.plain(report.warnings.front());
  } catch (const InputError& error) {
    refusal.said = file.plain(error.what());
  }
  return refusal;
}

std::string obj_with(std::string_view number) {
  return "v 0 0 0\nv 1 0 0\nv 0 1 " + std::string(number) + "\nf 1 2 3\n";
}

std::string ply_with(std::string_view number) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 " +
         std::string(number) + "\n3 0 1 2\n";
}

/// A binary PLY file, whose last coordinate has these bytes.
std::string binary_ply_with(const std::array<char, 4>& bytes) {
  std::string file =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  constexpr std::array zero = {'\0', '\0', '\0', '\0'};
  constexpr std::array one = {'\0', '\0', '\x80', '\x3f'};
  for (const std::array<char, 4>& number : {zero, zero, zero, one, zero, zero, zero, one, bytes}) {
    file.append(number.data(), number.size());
  }
  const std::string index = {'\x03', '\0', '\0',   '\0', '\0', '\x01', '\0',
                             '\0',   '\0', '\x02', '\0', '\0', '\0'};
  return file + index;
}

struct Seen {
  Camera camera = {.eye = {0.0, 0.0, 4.0}, .target = {0.0, 0.0, 0.0}};
  std::optional<double> near_depth = std::nullopt;
  std::optional<double> far_depth = std::nullopt;
};

Refusal of_view(std::string what, const std::function<void(Seen&)>& change) {
  Scene scene;
  scene.positions = {{0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}};
  scene.triangles.push_back({{0, 1, 2}, 0, no_material});
  Seen seen;
  change(seen);
  Refusal refusal = {std::move(what), ""};
  try {
    (void)make_view(scene, seen.camera, 8, 8, seen.near_depth, seen.far_depth);
  } catch (const UsageError& error) {
    refusal.said = error.what();
  }
  return refusal;
}

}  // namespace

std::vector<Refusal> try_refusals() {
  return {
      of_file("NaN as a position in OBJ", ".obj", obj_with("nan")),
      of_file("infinity as a position in OBJ", ".obj", obj_with("inf")),
      of_file("1e39, beyond float32, as a position in OBJ", ".obj", obj_with("1e39")),
      of_file("NaN as a position in PLY", ".ply", ply_with("nan")),
      of_file("the bits of NaN in binary PLY", ".ply", binary_ply_with({'\0', '\0', '\xc0', '\x7f'})),
      of_file("the bits of infinity in binary PLY", ".ply", binary_ply_with({'\0', '\0', '\x80', '\x7f'})),
      of_view("NaN in the eye", [](Seen& seen) { seen.camera.eye.x = nan; }),
      of_view("infinity in the eye", [](Seen& seen) { seen.camera.eye.y = infinity; }),
      of_view("NaN in the target", [](Seen& seen) { seen.camera.target.z = nan; }),
      of_view("NaN as the way up", [](Seen& seen) { seen.camera.up.x = nan; }),
      of_view("an eye on its target", [](Seen& seen) { seen.camera.eye = seen.camera.target; }),
      of_view("up along the line of sight",
              [](Seen& seen) {
                seen.camera.up = {0.0, 0.0, 1.0};
              }),
      of_view("NaN as the field of view", [](Seen& seen) { seen.camera.vertical_fov_degrees = nan; }),
      of_view("a field of view of 180 degrees", [](Seen& seen) { seen.camera.vertical_fov_degrees = 180.0; }),
      of_view("NaN as near", [](Seen& seen) { seen.near_depth = nan; }),
      of_view("near of 0", [](Seen& seen) { seen.near_depth = 0.0; }),
      of_view("infinity as far", [](Seen& seen) { seen.far_depth = infinity; }),
      of_view("far before near",
              [](Seen& seen) {
                seen.near_depth = 2.0;
                seen.far_depth = 1.0;
              }),
  };
}

}  // namespace hsr::stress
