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

  /// Adds `count` triangles, about as wide as high, to `faces`: rows of them, each with a triangle for every
  /// edge of the lines below and above it. So neighbours share their corners, whatever the count.
  void add(int count, std::vector<std::array<std::uint32_t, 3>>& faces) {
    constexpr double aspect = 16.0 / 9.0;
    const int rows = std::max(1, static_cast<int>(std::lround(std::sqrt(count / (2.0 * aspect)))));
    const int each = std::max(1, count / (2 * rows));
    int left = count - 2 * rows * each;  // an edge more of a line between two rows is two triangles more
    std::vector<std::uint32_t> below;
    for (int line = 0; line <= rows; ++line) {
      const bool inside = line > 0 && line < rows;
      const bool more = inside && left >= 2;
      if (more) left -= 2;
      const int edges = line == rows ? std::max(0, each + left) : each + (more ? 1 : 0);
      std::vector<std::uint32_t> above = vertices(edges, static_cast<double>(line) / rows);
      if (line > 0) join(below, above, faces);
      below = std::move(above);
    }
  }

 private:
  /// A point at shares u, v of the picture; its depth depends on v alone.
  std::uint32_t vertex(double u, double v) {
    constexpr double waves = 1.5;
    constexpr double half_height = 0.4142135623730951 * 1.02;  // of a picture at distance 1, with a margin
    constexpr double half_width = half_height * 16.0 / 9.0;
    const double z = middle_ + amplitude_ * std::sin(2.0 * std::numbers::pi * waves * v);
    const double away = eye_z - z;
    return builder_.vertex({(2.0 * u - 1.0) * half_width * away, (2.0 * v - 1.0) * half_height * away, z});
  }

  /// The corners of a line with so many edges from the left to the right; a line without edges is a point.
  std::vector<std::uint32_t> vertices(int edges, double v) {
    std::vector<std::uint32_t> line;
    for (int k = 0; k <= edges; ++k)
      line.push_back(vertex(edges == 0 ? 0.0 : static_cast<double>(k) / edges, v));
    return line;
  }

  /// A triangle for every edge of both lines, from the left to the right.
  static void join(const std::vector<std::uint32_t>& below, const std::vector<std::uint32_t>& above,
                   std::vector<std::array<std::uint32_t, 3>>& faces) {
    std::size_t b = 0;
    std::size_t a = 0;
    while (b + 1 < below.size() || a + 1 < above.size()) {
      const bool from_below =
          a + 1 == above.size() ||
          (b + 1 < below.size() && (b + 1) * (above.size() - 1) <= (a + 1) * (below.size() - 1));
      if (from_below) {
        faces.push_back({below[b], below[b + 1], above[a]});
        ++b;
      } else {
        faces.push_back({above[a], below[b], above[a + 1]});
        ++a;
      }
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
