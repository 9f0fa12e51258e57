#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"
#include "scene/built_in/random.h"

namespace hsr::built_in {
namespace {

constexpr std::array<SceneParameter, 2> sheets_parameters{{
    {"n", "number of triangles", 400, 1, 10000000, true},
    {"depth", "number of sheets, one behind the other", 4, 1, 1000, true},
}};

constexpr double eye_z = 4.0;

/// How many of `count` things go to part k of `parts`, which differ by one at most.
int share(std::int64_t count, std::int64_t k, std::int64_t parts) {
  return static_cast<int>((k + 1) * count / parts - k * count / parts);
}

/// A sheet that fills a picture of 16:9 as seen from the eye, in rows of triangles that rise and fall.
class Sheet {
 public:
  Sheet(MeshBuilder& builder, double middle, double amplitude)
      : builder_(builder), middle_(middle), amplitude_(amplitude) {}

  /// Adds `count` triangles, about as wide as high, to `faces`.
  void add(int count, std::vector<std::array<std::uint32_t, 3>>& faces) {
    constexpr double aspect = 16.0 / 9.0;
    const int rows = std::clamp(static_cast<int>(std::lround(std::sqrt(count / (2.0 * aspect)))), 1, count);
    for (int row = 0; row < rows; ++row) {
      const int here = share(count, row, rows);
      add_row(static_cast<double>(row) / rows, (row + 1.0) / rows, here, faces);
    }
  }

 private:
  /// A point at shares u, v of the picture. Depth depends on v alone, so that rows meet in straight lines,
  /// whatever their number of triangles.
  std::uint32_t vertex(double u, double v) {
    constexpr double waves = 1.5;
    constexpr double half_height = 0.4142135623730951 * 1.02;  // of a picture at distance 1, with a margin
    constexpr double half_width = half_height * 16.0 / 9.0;
    const double z = middle_ + amplitude_ * std::sin(2.0 * std::numbers::pi * waves * v);
    const double away = eye_z - z;
    return builder_.vertex({(2.0 * u - 1.0) * half_width * away, (2.0 * v - 1.0) * half_height * away, z});
  }

  /// A row from the left to the right, with a triangle for every edge above and below; a row of one triangle
  /// cannot fill its half of the picture, and leaves a corner empty.
  void add_row(double bottom, double top, int count, std::vector<std::array<std::uint32_t, 3>>& faces) {
    const int below = (count + 1) / 2;
    const int above = count / 2;
    std::uint32_t left_below = vertex(0.0, bottom);
    std::uint32_t left_above = vertex(0.0, top);
    for (int k = 0; k < below; ++k) {
      const std::uint32_t right_below = vertex((k + 1.0) / below, bottom);
      faces.push_back({left_below, right_below, left_above});
      left_below = right_below;
      if (k >= above) continue;
      const std::uint32_t right_above = vertex((k + 1.0) / above, top);
      faces.push_back({left_above, left_below, right_above});
      left_above = right_above;
    }
  }

  MeshBuilder& builder_;
  double middle_;
  double amplitude_;
};

// The sheets rise and fall together, so they never meet, though neighbours reach into each other's depths.
Scene make_sheets(std::span<const double> values) {
  const int n = static_cast<int>(values[0]);
  const int sheets = std::min(static_cast<int>(values[1]), n);
  MeshBuilder builder("sheets");
  const double apart = 2.0 / sheets;
  std::vector<std::array<std::uint32_t, 3>> faces;
  for (int k = 0; k < sheets; ++k) {
    Sheet(builder, 1.0 - (k + 0.5) * apart, 0.8 * apart).add(share(n, k, sheets), faces);
  }
  // In no order, as in a scene that nobody sorted.
  Random random(6);
  for (std::size_t k = faces.size(); k > 1; --k) {
    const auto other = static_cast<std::size_t>(random.unit() * static_cast<double>(k));
    std::swap(faces[k - 1], faces[other]);
  }
  for (const std::array<std::uint32_t, 3>& face : faces) builder.face(face);
  return builder.finish({.eye = {0.0, 0.0, eye_z}, .target = {0.0, 0.0, 0.0}});
}

}  // namespace

constinit const SceneEntry sheets{
    .name = "sheets",
    .title = "Sheets of small triangles",
    .shows =
        "Wavy sheets that fill the picture, so that number of triangles and depth complexity can be chosen "
        "apart from each other.",
    .parameters = sheets_parameters,
    .make = make_sheets};

}  // namespace hsr::built_in
