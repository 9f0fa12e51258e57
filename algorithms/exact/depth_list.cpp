#include "exact/depth_list.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "exact/worker.h"

namespace hsr::exact {

namespace {

/// In clip space the ray through a sample (X, Y) is where u = x - X w and v = y - Y w are both 0. If u
/// is above 0 at all three corners of a triangle, it is so in all of the triangle, which then does not
/// meet the ray; the same below 0, and for v.
///
/// Rounding: with S = sum of (|m_x| + |m_w|) |position| over the four terms, the matrix row of u is off
/// by less than 4 · 2^-53 of (|m_x| + |m_w|) per entry (X, the product, the difference), and the sum of
/// four products by less than 4 · 2^-53 S more; 2^-49 S is twice as much. What underflows is covered by
/// the smallest summand; what overflows makes the bound infinite or NaN, and no side certain.
class SidesOfRay {
 public:
  SidesOfRay(const View& view, int i, int j)
      : u_(row(view, 0, (2.0 * i + 1.0 - view.width) / view.width)),
        v_(row(view, 1, (view.height - 2.0 * j - 1.0) / view.height)) {}

  /// Which sides a point surely lies on, a bit for each of u > 0, u < 0, v > 0, v < 0.
  std::uint8_t of(const glm::vec3& point) const {
    return static_cast<std::uint8_t>(side(u_, point) | side(v_, point) << 2);
  }

 private:
  struct Row {
    std::array<double, 4> value;
    std::array<double, 4> size;
  };

  static Row row(const View& view, glm::length_t axis, double sample) {
    Row row{};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto column = static_cast<glm::length_t>(k);
      const double of_axis = view.clip_from_world[column][axis];
      const double of_w = view.clip_from_world[column][3];
      row.value[k] = of_axis - sample * of_w;
      row.size[k] = std::abs(of_axis) + std::abs(of_w);
    }
    return row;
  }

  static unsigned side(const Row& row, const glm::vec3& point) {
    const std::array<double, 4> position = {point.x, point.y, point.z, 1.0};
    double value = 0.0;
    double size = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
      value += row.value[k] * position[k];
      size += row.size[k] * std::abs(position[k]);
    }
    constexpr double smallest = 1e-290;
    const double bound = 0x1p-49 * size + smallest;
    return (value > bound ? 1U : 0U) | (value < -bound ? 2U : 0U);
  }

  Row u_;
  Row v_;
};

}  // namespace

std::vector<Fragment> depth_list(const View& view, int i, int j) {
  const Scene& scene = *view.scene;
  const SidesOfRay sides(view, i, j);
  std::vector<std::uint8_t> side(scene.positions.size());
  for (std::size_t vertex = 0; vertex < side.size(); ++vertex)
    side[vertex] = sides.of(scene.positions[vertex]);

  // A scene of what is left, in the same order.
  Scene rest;
  std::vector<std::uint32_t> id_of;
  for (std::size_t id = 0; id < scene.triangles.size(); ++id) {
    const auto& corners = scene.triangles[id].corners;
    if ((side[corners[0]] & side[corners[1]] & side[corners[2]]) != 0) continue;
    Triangle triangle = scene.triangles[id];
    for (std::uint32_t& corner : triangle.corners) {
      rest.positions.push_back(scene.positions[corner]);
      corner = static_cast<std::uint32_t>(rest.positions.size() - 1);
    }
    rest.triangles.push_back(triangle);
    id_of.push_back(static_cast<std::uint32_t>(id));
  }
  View view_of_rest = view;
  view_of_rest.scene = &rest;
  std::vector<Fragment> list = ExactAnswer(view_of_rest, 1).worker().depth_list(i, j);
  for (Fragment& fragment : list) fragment.id = id_of[fragment.id];
  return list;
}

}  // namespace hsr::exact
