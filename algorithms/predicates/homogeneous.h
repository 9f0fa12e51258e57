#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>

namespace hsr {

/// The part of a view that decides visibility, as plain numbers.
///
/// A sample is a point (raster_x, raster_y) of the picture, named by the doubles a = 2 raster_x - W
/// and b = H - 2 raster_y, so that clip x / w = a / W and clip y / w = b / H. The centre of pixel
/// (i, j) is a = 2i + 1 - W, b = H - 2j - 1: whole numbers, no rounding.
struct Projection {
  std::array<std::array<double, 4>, 3> rows{};  ///< the rows of clip_from_world that give x, y and w
  int width = 0;                                ///< W, pixels
  int height = 0;                               ///< H, pixels
  double near_depth = 0.0;                      ///< eye depth, scene units, above 0
  double far_depth = 0.0;                       ///< eye depth, scene units, above near_depth
};

/// The sample coordinates a, b of the centre of column i, row j of a picture.
inline double centre_a(int width, int i) { return 2.0 * i + 1.0 - width; }
inline double centre_b(int height, int j) { return height - 2.0 * j - 1.0; }

/// A vector of the three homogeneous coordinates that matter for visibility: clip x, y and w.
template <class Number>
using Homogeneous = std::array<Number, 3>;

template <class Number>
Homogeneous<Number> cross(const Homogeneous<Number>& a, const Homogeneous<Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Number>
Number dot(const Homogeneous<Number>& a, const Homogeneous<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Number>
Homogeneous<Number> operator-(const Homogeneous<Number>& a, const Homogeneous<Number>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Clip x, y and w of a point in world space.
template <class Number>
Homogeneous<Number> clip_from_world(const Projection& projection, const glm::vec3& world) {
  Homogeneous<Number> clip;
  for (std::size_t r = 0; r < 3; ++r) {
    const std::array<double, 4>& row = projection.rows[r];
    clip[r] = Number(row[0]) * Number(double{world.x}) + Number(row[1]) * Number(double{world.y}) +
              Number(row[2]) * Number(double{world.z}) + Number(row[3]);
  }
  return clip;
}

/// A triangle in homogeneous coordinates (Olano and Greer 1997, section 3), in the sample
/// coordinates of Projection.
///
/// With corners c_k, e_k = c_{k+1} × c_{k+2} and det = c_0 · e_0, a sample p = (a/W, b/H, 1) is
/// covered iff every e_k · p / det >= 0, and 1 / eye depth = Σ e_k · p / det there. All of it is
/// scaled by W · H, which is positive, so that p becomes (a H, b W, W H) without a division.
/// Signs are those of e_k · p; a caller divides by the sign of `det`.
template <class Number>
struct HomogeneousTriangle {
  std::array<Homogeneous<Number>, 3> edge;  ///< e_k scaled: e_k · p · W H = edge · (a, b, 1)
  Homogeneous<Number> sum;                  ///< Σ e_k scaled in the same way
  Number det;                               ///< det · W H: 1 / eye depth = sum · (a, b, 1) / det
};

template <class Number>
HomogeneousTriangle<Number> homogeneous_triangle(const Projection& projection,
                                                 const std::array<Homogeneous<Number>, 3>& corner) {
  const Number w(static_cast<double>(projection.width));
  const Number h(static_cast<double>(projection.height));
  const Number w_times_h(static_cast<double>(projection.width) * static_cast<double>(projection.height));
  const auto scaled = [&](const Homogeneous<Number>& vector) {
    return Homogeneous<Number>{vector[0] * h, vector[1] * w, vector[2] * w_times_h};
  };
  HomogeneousTriangle<Number> triangle;
  for (std::size_t k = 0; k < 3; ++k) {
    triangle.edge[k] = scaled(cross(corner[(k + 1) % 3], corner[(k + 2) % 3]));
  }
  // Σ e_k = (c_1 - c_0) × (c_2 - c_0) and det = c_0 · Σ e_k: equal in exact arithmetic, and with
  // differences of corners the bounds of a small triangle stay small.
  const Homogeneous<Number> sum = cross(corner[1] - corner[0], corner[2] - corner[0]);
  triangle.sum = scaled(sum);
  triangle.det = dot(corner[0], sum) * w_times_h;
  return triangle;
}

/// The value of a scaled vector at a sample.
template <class Number>
Number at_sample(const Homogeneous<Number>& vector, double a, double b) {
  return vector[0] * Number(a) + vector[1] * Number(b) + vector[2];
}

}  // namespace hsr
