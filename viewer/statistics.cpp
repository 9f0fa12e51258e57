#include "statistics.h"

#include <nlohmann/json.hpp>

namespace hsr {
namespace {

using Json = nlohmann::ordered_json;

/// Row by row, as one reads a matrix.
Json row_by_row(const glm::dmat4& matrix) {
  Json numbers = Json::array();
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) numbers.push_back(matrix[column][row]);
  }
  return numbers;
}

Json point(const glm::dvec3& point) { return {point.x, point.y, point.z}; }

Json camera(const Camera& camera) {
  return {{"eye", point(camera.eye)},
          {"target", point(camera.target)},
          {"up", point(camera.up)},
          {"fov", camera.vertical_fov_degrees}};
}

}  // namespace

std::string to_json(const Statistics& statistics) {
  const View& view = *statistics.view;
  const Json json = {
      {"scene", view.scene->name},
      {"triangles", view.scene->triangles.size()},
      {"warnings", statistics.warnings},
      {"algorithm", statistics.algorithm->algorithm->name},
      {"settings", statistics.algorithm->settings},
      {"width", view.width},
      {"height", view.height},
      {"threads", statistics.threads},
      {"repeats", statistics.repeats},
      {"camera", camera(view.camera)},
      {"view_projection", row_by_row(view.clip_from_world)},
      {"near", view.near_depth},
      {"far", view.far_depth},
      {"time_ms",
       {{"load", statistics.load_ms}, {"prepare", statistics.prepare_ms}, {"render", statistics.render_ms}}},
      {"skipped", statistics.report->skipped},
      {"counters", statistics.report->counters},
      {"bytes", statistics.report->bytes},
  };
  // A file's name may hold bytes that are not UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace hsr
