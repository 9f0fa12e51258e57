#include <array>
#include <cmath>

#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"

namespace hsr::built_in {
namespace {

constexpr std::array<SceneParameter, 3> aligned_grid_parameters{{
    {"n", "squares along a side", 79, 1, 2000, true},
    {"step", "size of a square in pixels", 8, 1, 64, true},
    {"height", "height in pixels of the picture whose pixels the grid is aligned to", 720, 2, 8192, true},
}};

// The tangent of half this angle is 1/4, in double arithmetic as the view does it too. So from twice
// `height` away a unit is a pixel, and a row of pixel centres is a row of half-integers, or of integers
// if the height is odd. All numbers are exact; the columns are so where width / height is a power of
// two, and elsewhere are within a rounding error, which is the harder case.
constexpr double fov_degrees = 28.07248693585296;

// The black squares of a chess board at the distance at which a unit is a pixel, before a complete
// board at twice the distance with all coordinates doubled, moved by half a square.
Scene make_aligned_grid(std::span<const double> values) {
  const int n = static_cast<int>(values[0]);
  const int step = static_cast<int>(values[1]);
  const int height = static_cast<int>(values[2]);
  const double eye_distance = 2.0 * height;
  const double centre_offset = height % 2 == 0 ? 0.5 : 0.0;
  const int start = -(n * step / 2);
  MeshBuilder builder("aligned-grid");
  const auto square = [&](int row, int column, int shift, double scale) {
    const double x = start + column * step + shift + centre_offset;
    const double y = start + row * step + shift + centre_offset;
    builder.parallelogram({scale * x, scale * y, eye_distance * (1.0 - scale)}, {scale * step, 0.0, 0.0},
                          {0.0, scale * step, 0.0});
  };
  for (int row = 0; row < n; ++row) {
    for (int column = row % 2; column < n; column += 2) square(row, column, 0, 1.0);
  }
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) square(row, column, step / 2, 2.0);
  }
  return builder.finish(
      {.eye = {0.0, 0.0, eye_distance}, .target = {0.0, 0.0, 0.0}, .vertical_fov_degrees = fov_degrees});
}

}  // namespace

constinit const SceneEntry aligned_grid{
    .name = "aligned-grid",
    .title = "Corners and edges on pixel centres",
    .shows =
        "Every corner, edge and diagonal runs through centres of pixels, where only exact signs are right.",
    .parameters = aligned_grid_parameters,
    .make = make_aligned_grid};

}  // namespace hsr::built_in
