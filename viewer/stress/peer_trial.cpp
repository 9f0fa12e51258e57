#include "stress/peer_trial.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/write_scene.h"
#include "view/view.h"

namespace hsr::stress {
namespace {

/// A file with a scene, which goes when it is no longer needed.
class TemporaryScene {
 public:
  explicit TemporaryScene(const Scene& scene)
      : file_(std::filesystem::temp_directory_path() / ("hsr-stress-" + std::to_string(getpid()) + ".ply")) {
    write_scene(scene, file_);
  }
  ~TemporaryScene() {
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
  }
  TemporaryScene(const TemporaryScene&) = delete;
  TemporaryScene& operator=(const TemporaryScene&) = delete;
  std::string name() const { return file_.string(); }

 private:
  std::filesystem::path file_;
};

std::string text(double number) {
  std::array<char, 40> buffer{};
  (void)std::snprintf(buffer.data(), buffer.size(), "%.17g", number);
  return buffer.data();
}

std::string text(const glm::dvec3& point) {
  return text(point.x) + "," + text(point.y) + "," + text(point.z);
}

}  // namespace

PeerPicture picture_of_peer(const bench::PeerEntry& peer, const Problem& problem) {
  const TemporaryScene scene(problem.scene);
  const Camera& camera = *problem.scene.camera;
  std::vector<std::string> environment = {"HSR_EYE=" + text(camera.eye), "HSR_TARGET=" + text(camera.target),
                                          "HSR_UP=" + text(camera.up),
                                          "HSR_FOV=" + text(camera.vertical_fov_degrees)};
  if (problem.near_depth) environment.push_back("HSR_NEAR=" + text(*problem.near_depth));
  if (problem.far_depth) environment.push_back("HSR_FAR=" + text(*problem.far_depth));
  const auto contestant =
      bench::start(peer, scene.name(), problem.width, problem.height, 1, std::move(environment));
  PeerPicture picture;
  picture.ms = contestant->run();
  picture.frame = contestant->picture();
  return picture;
}

}  // namespace hsr::stress
