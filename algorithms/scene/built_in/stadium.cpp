#include <array>
#include <cmath>
#include <numbers>

#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"
#include "scene/built_in/okabe_ito.h"
#include "scene/built_in/teapot.h"

namespace hsr::built_in {
namespace {

constexpr std::array<SceneParameter, 1> stadium_parameters{{
    {"subdivision", "squares along a side of each of the teapot's 32 patches", 16, 2, 64, true},
}};

constexpr int segments = 72;  // of the oval
constexpr int rows = 18;      // of seats

// A point of the oval whose half axes are 62 and 44 units at offset 0. `at` counts segments.
glm::dvec3 on_oval(double offset, double y, double at) {
  const double angle = 2.0 * std::numbers::pi * at / segments;
  return {(62.0 + offset) * std::cos(angle), y, (44.0 + offset) * std::sin(angle)};
}

// A quadrilateral over the part [begin, end] of a segment, from one offset and height to another.
void add_band(MeshBuilder& builder, double begin, double end, double offset_0, double y_0, double offset_1,
              double y_1) {
  builder.polygon({on_oval(offset_0, y_0, end), on_oval(offset_0, y_0, begin), on_oval(offset_1, y_1, begin),
                   on_oval(offset_1, y_1, end)});
}

// Steps of 2 units depth and 1 unit height, with seats 0.05 units before the risers and boards before
// the lowest one.
void add_stands(MeshBuilder& builder) {
  const std::uint32_t concrete = builder.material("concrete", okabe_ito::light_grey);
  const std::array<std::uint32_t, 4> seats{
      builder.material("blue seats", okabe_ito::blue), builder.material("yellow seats", okabe_ito::yellow),
      builder.material("red seats", okabe_ito::vermilion), builder.material("white seats", okabe_ito::white)};
  for (int row = 0; row < rows; ++row) {
    const double offset = 2.0 * row;
    const double y = 1.0 + row;
    for (int k = 0; k < segments; ++k) {
      builder.use_material(concrete);
      add_band(builder, k, k + 1, offset, row == 0 ? 0.0 : y - 1.0, offset, y);
      add_band(builder, k, k + 1, offset, y, offset + 2.0, y);
      const auto color = static_cast<std::size_t>(row == 0 ? k : k / 6) % seats.size();
      builder.use_material(seats[color]);
      add_band(builder, k + 0.1, k + 0.9, offset - 0.05, y - 0.75, offset - 0.05, y - 0.125);
    }
  }
  builder.use_material(concrete);
  for (int k = 0; k < segments; ++k) add_band(builder, k + 1, k, 2.0 * rows, 0.0, 2.0 * rows, rows);
}

// A line of the pitch from (x0, z0) to (x1, z1), 0.25 units wide, parallel to an axis.
void add_line(MeshBuilder& builder, double x0, double z0, double x1, double z1) {
  constexpr double y = 0.0625;
  constexpr double half = 0.125;
  builder.parallelogram({x0 - half, y, z1 + half}, {x1 - x0 + 2.0 * half, 0.0, 0.0},
                        {0.0, 0.0, z0 - z1 - 2.0 * half});
}

// The lawn lies 1/32 above the ground, in mown strips that touch, and its lines another 1/32 above.
void add_pitch(MeshBuilder& builder) {
  builder.material("ground", 0x9C7A55);
  builder.parallelogram({-100.0, 0.0, 82.0}, {200.0, 0.0, 0.0}, {0.0, 0.0, -164.0});
  const std::uint32_t light = builder.material("light grass", 0x4CB88A);
  const std::uint32_t dark = builder.material("dark grass", okabe_ito::bluish_green);
  for (int strip = 0; strip < 14; ++strip) {
    builder.use_material(strip % 2 == 0 ? light : dark);
    builder.parallelogram({-42.0 + 6.0 * strip, 0.03125, 27.0}, {6.0, 0.0, 0.0}, {0.0, 0.0, -54.0});
  }
  builder.material("line", okabe_ito::white);
  for (const double side : {-1.0, 1.0}) {
    add_line(builder, -40.0, 25.0 * side, 40.0, 25.0 * side);
    add_line(builder, 40.0 * side, -25.0, 40.0 * side, 25.0);
  }
  add_line(builder, 0.0, -25.0, 0.0, 25.0);
  for (int k = 0; k < segments; ++k) {
    const auto on_circle = [k](double radius, int step) {
      const double angle = 2.0 * std::numbers::pi * (k + step) / segments;
      return glm::dvec3(radius * std::cos(angle), 0.0625, radius * std::sin(angle));
    };
    builder.polygon({on_circle(7.125, 0), on_circle(6.875, 0), on_circle(6.875, 1), on_circle(7.125, 1)});
  }
}

Scene make_stadium(std::span<const double> values) {
  MeshBuilder builder("stadium");
  add_pitch(builder);
  add_stands(builder);
  add_teapot(builder, static_cast<int>(values[0]), 0.5, {0.0, 0.0625, 0.0});
  return builder.finish({.eye = {4.5, 2.25, 8.5}, .target = {0.0, 1.25, 0.0}, .vertical_fov_degrees = 30.0});
}

}  // namespace

constinit const SceneEntry stadium{
    .name = "stadium",
    .title = "The teapot in a stadium",
    .shows =
        "A fine mesh in the middle of a large coarse scene: hard for uniform grids and for 16 bits of depth.",
    .parameters = stadium_parameters,
    .make = make_stadium};

}  // namespace hsr::built_in
