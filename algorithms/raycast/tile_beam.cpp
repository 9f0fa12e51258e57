#include "raycast/tile_beam.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "predicates/dyadic.h"
#include "predicates/homogeneous.h"
#include "raycast/eye_rays.h"
#include "raycast/leaf_lanes.h"
#include "view/screen_triangles.h"

namespace hsr {

namespace {

constexpr double u = 0x1p-24;
constexpr double v = 0x1p-53;
constexpr float least_float = std::numeric_limits<float>::min();

// Clip x, y and w of a point, exact and then rounded towards zero.
Homogeneous<double> rounded_clip(const Projection& projection, const glm::vec3& point) {
  const Homogeneous<Dyadic> exact = clip_from_world<Dyadic>(projection, point);
  Homogeneous<double> rounded{};
  for (std::size_t r = 0; r < 3; ++r) {
    long exponent = 0;
    const double fraction = exact[r].rounded(exponent);
    rounded[r] = std::ldexp(fraction, static_cast<int>(exponent));
  }
  return rounded;
}

// The plane of a row in float. Its constant is moved by 8 units, by what may underflow, and by `error`.
TileBeam::Plane moved_plane(const lanes::RasterView::Row& row, double factor, double direction,
                            double error) {
  TileBeam::Plane plane{};
  for (std::size_t axis = 0; axis < 3; ++axis) plane.normal[axis] = static_cast<float>(row[axis] * factor);
  const double constant = row[3] * factor;
  const double margin = 8.0 * u * std::abs(constant) + error * factor + 8.0 * double{least_float};
  plane.constant = static_cast<float>(constant + direction * margin);
  return plane;
}

// row - border depth, rounded.
TileBeam::Plane difference(const lanes::RasterView::Row& row, const lanes::RasterView::Row& depth,
                           double border) {
  TileBeam::Plane plane{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    plane.normal[axis] = static_cast<float>(row[axis] - border * depth[axis]);
  }
  plane.constant = static_cast<float>(row[3] - border * depth[3]);
  return plane;
}

}  // namespace

BeamView::BeamView(const View& view, const lanes::RasterView& raster, const glm::vec3& reference)
    : rows_(raster.rows) {
  const Homogeneous<double> clip = rounded_clip(projection_of(view), reference);
  const double x = clip[0];
  const double y = clip[1];
  const double w = clip[2];
  rows_[0][3] = (x + w) * (view.width / 2.0);
  rows_[1][3] = (w - y) * (view.height / 2.0);
  rows_[2][3] = w;
  // 2 v from rounding towards zero, 2 v from the rows, 2 v from a border times w and the difference.
  const double greatest_constant = (std::max(std::abs(x), std::abs(y)) + 3.0 * std::abs(w)) * raster.reach;
  constant_error_ = 8.0 * v * greatest_constant;

  // Planes are differences of rows that RasterView::magnitude bounds.
  const double normal = raster.magnitude[0] + raster.magnitude[1] + raster.magnitude[2];
  int exponent = 0;
  std::frexp(std::max(normal, std::numeric_limits<double>::min()), &exponent);
  factor_ = std::ldexp(1.0, -exponent - 2);
  depth_ = moved_plane(rows_[2], factor_, -1.0, constant_error_);
  // Twice the distance between the constant rounded down and rounded up, and a rounding more.
  depth_margin_ =
      static_cast<float>(32.0 * u * std::abs(rows_[2][3] * factor_) + 4.0 * constant_error_ * factor_) +
      32.0F * least_float;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box_error_[axis] = hsr::box_error * static_cast<float>(raster.magnitude[axis]);
  }
  box_error_[3] = hsr::box_error * static_cast<float>(greatest_constant);

  // The greatest coordinate of a point that is seen at the near depth; in relation to their depth, points
  // behind it are less far away.
  const EyeRays rays(view);
  const double far_reference =
      std::max({std::abs(reference.x), std::abs(reference.y), std::abs(reference.z)});
  const double greatest = rays.greatest_coordinate(view.near_depth) + rays.margin() + far_reference;
  const double lost = 8.0 * v * normal * greatest;
  trusted_ = lost < 0.5 * beam_margin * view.near_depth;
}

// sign (row - border w) >= 0.
TileBeam::Plane BeamView::side(const Row& row, double sign, double border) const {
  Row plane{};
  for (std::size_t k = 0; k < 4; ++k) plane[k] = sign * (row[k] - border * rows_[2][k]);
  TileBeam::Plane rounded = moved_plane(plane, factor_, 1.0, constant_error_);
  if (!trusted_) rounded.constant = std::numeric_limits<float>::infinity();
  return rounded;
}

TileBeam BeamView::beam(int first_i, int first_j) const {
  constexpr double before = 0.5 - beam_margin;
  constexpr double behind = tile_side - 0.5 + beam_margin;
  TileBeam beam{};
  beam.side[0] = side(rows_[0], 1.0, first_i + before);
  beam.side[1] = side(rows_[0], -1.0, first_i + behind);
  beam.side[2] = side(rows_[1], 1.0, first_j + before);
  beam.side[3] = side(rows_[1], -1.0, first_j + behind);
  beam.depth = depth_;
  beam.depth_margin = depth_margin_;
  beam.corner_x = difference(rows_[0], rows_[2], first_i + 0.5);
  beam.corner_y = difference(rows_[1], rows_[2], first_j + 0.5);
  beam.corner_w = difference(rows_[2], {}, 0.0);
  return beam;
}

}  // namespace hsr
