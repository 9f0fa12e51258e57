#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "lanes/raster_view.h"
#include "view/view.h"

namespace hsr {

/// The side of a tile, in pixels.
inline constexpr int tile_side = 16;

/// The beam of all rays through the centres of a tile's pixels, for tests of boxes in float.
///
/// A box that WideHierarchy made lies surely outside one of the four planes where the greatest of
/// n · p + constant over its corners is negative; p is relative to the hierarchy's reference point.
///
/// Why no covered point is lost. Let the point q at depth w >= near be seen through the tile. At a corner b
/// of a box, a plane's value in float is off by less than 6 u of |n_i b_i| for the terms and 6 u of
/// |constant| (u = 2^-24: one rounding for the entry of the normal, one for the product, three for the sums,
/// and one for all that is smaller). Boxes are widened by 16 u of their coordinates, constants moved by 8 u
/// and more; so the value is at least the plane's value at q, had its entries been rounded in double only.
/// They are differences in double, off by 4 v (v = 2^-53) of the terms that make them up,
/// RasterView::magnitude, however small they themselves are. For this the planes run `beam_margin` pixels
/// outside the outermost centres, where their value at q is at least that times w; BeamView proves once per
/// frame that this is more, and if it is not, the constants are infinite and no box is missed.
struct TileBeam {
  struct Plane {
    std::array<float, 3> normal;  ///< the sum of absolute values is at most 1/4, so that nothing overflows
    float constant;
  };
  std::array<Plane, 4> side;  ///< normals point inward; constants are rounded up
  Plane depth;                ///< eye depth times BeamView::factor(), rounded down
  float depth_margin;         ///< to be added to `depth` where an upper bound is wanted

  /// The homogeneous coordinates of points, in pixels from the first pixel's centre: x, y and depth. Rounded
  /// to nearest and not scaled.
  Plane corner_x, corner_y, corner_w;
};

inline constexpr double beam_margin = 0x1p-7;  ///< pixels

/// A view relative to a reference point among the triangles, from which beams are made. The image of the
/// reference point is computed exactly once per frame, so that what is far from the world's origin, but
/// close to that point, loses nothing.
class BeamView {
 public:
  BeamView(const View& view, const lanes::RasterView& raster, const glm::vec3& reference);

  /// The beam of the tile whose upper left pixel is (first_i, first_j).
  TileBeam beam(int first_i, int first_j) const;

  /// The power of two by which the values of a beam's planes are scaled.
  double factor() const { return factor_; }

  /// What to divide by the least depth of a leaf's corners to get the error of their pixel coordinates, if
  /// its corners are within `magnitude` of the reference point on each axis: see leaf_lanes.h.
  float box_error(const std::array<float, 3>& magnitude) const {
    return box_error_[0] * magnitude[0] + box_error_[1] * magnitude[1] + box_error_[2] * magnitude[2] +
           box_error_[3];
  }

 private:
  using Row = lanes::RasterView::Row;
  TileBeam::Plane side(const Row& row, double sign, double border) const;

  std::array<Row, 3> rows_{};  // as in RasterView; the constants are the image of the reference point
  double factor_ = 1.0;
  double constant_error_ = 0.0;
  std::array<float, 4> box_error_{};
  TileBeam::Plane depth_{};  // these do not depend on the tile
  float depth_margin_ = 0.0F;
  bool trusted_ = false;
};

}  // namespace hsr
