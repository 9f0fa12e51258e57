#include "window/results/model.h"

#include "picture.h"

namespace hsr::window {

Model make_model(const ModelKey& key, std::uint64_t number, const std::shared_ptr<const Scene>& unmoved,
                 const Progress& progress) {
  const Stopwatch stopwatch;
  Model model;
  model.number = number;
  model.key = key;
  ReadReport report;
  Scene scene = unmoved ? *unmoved : open_scene(key.scene, report, progress);
  for (const MovedCorner& moved : key.moved) {
    if (moved.corner < scene.positions.size()) scene.positions[moved.corner] = moved.position;
  }
  model.sphere = bounding_sphere(scene);
  model.scene = std::make_shared<const Scene>(std::move(scene));
  model.warnings = std::move(report.warnings);
  model.load_ms = stopwatch.milliseconds();
  return model;
}

bool operator==(const ViewKey& a, const ViewKey& b) {
  return a.model == b.model && a.size == b.size && a.camera.eye == b.camera.eye &&
         a.camera.target == b.camera.target && a.camera.up == b.camera.up &&
         a.camera.vertical_fov_degrees == b.camera.vertical_fov_degrees;
}

}  // namespace hsr::window
