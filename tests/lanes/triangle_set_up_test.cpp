// The filter's bounds, attacked: every certain answer of it is checked in exact arithmetic, with triangles
// and offsets that are as bad as can be.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lanes/triangle_set_up_test.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once per instruction set.
#include <hwy/highway.h>

#include "lanes/one_triangle.h"
#include "lanes/triangle_set_up-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hsr::test::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// The first lane of a set-up.
void set_up_one(const lanes::RasterView& view, const OneTriangle& triangle, OneSetUp& result) {
  const hn::ScalableTag<double> d;
  using V = hn::Vec<decltype(d)>;
  lanes::HWY_NAMESPACE::CornerLanes<V> corners;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (int axis = 0; axis < 3; ++axis) {
      corners.position[corner][axis] = hn::Set(d, double{triangle.corner[corner][axis]});
    }
  }
  const auto planes = lanes::HWY_NAMESPACE::set_up_triangles(
      d, view, corners,
      {hn::Set(d, triangle.origin_i + 0.5), hn::Set(d, triangle.origin_j + 0.5),
       hn::Set(d, double(triangle.reach_x)), hn::Set(d, double(triangle.reach_y))});
  for (int k = 0; k < 4; ++k) {
    const auto& plane = k < 3 ? planes.edge[k] : planes.inverse_depth;
    result.plane[k][0] = hn::GetLane(plane.x);
    result.plane[k][1] = hn::GetLane(plane.y);
    result.plane[k][2] = hn::GetLane(plane.w);
  }
  result.depth_error = hn::GetLane(planes.depth_error);
  result.certain = hn::GetLane(hn::IfThenElse(planes.certain, hn::Set(d, 1.0), hn::Zero(d))) != 0.0;
}

}  // namespace hsr::test::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "lanes/instruction_sets.h"
#include "support/effort.h"
#include "view/view.h"

namespace hsr::test {

HWY_EXPORT(set_up_one);

namespace {

using Exact = std::array<mpq_class, 3>;

Exact cross(const Exact& p, const Exact& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
mpq_class dot(const Exact& p, const Exact& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

// The planes of a triangle as functions of raster coordinates, straight from the definition.
struct ExactPlanes {
  Exact plane[4];  // the edges times the sign of det, and 1 / depth
  int orientation = 0;
};

ExactPlanes exact_planes(const View& view, const OneTriangle& triangle) {
  Exact corner[3];
  for (std::size_t k = 0; k < 3; ++k) {
    mpq_class clip[4];
    for (int row = 0; row < 4; ++row) {
      clip[row] = mpq_class(view.clip_from_world[3][row]);
      for (int axis = 0; axis < 3; ++axis) {
        clip[row] += mpq_class(view.clip_from_world[axis][row]) * mpq_class(double{triangle.corner[k][axis]});
      }
    }
    corner[k] = {(clip[0] + clip[3]) * mpq_class(view.width, 2),
                 (clip[3] - clip[1]) * mpq_class(view.height, 2), clip[3]};
  }
  ExactPlanes result;
  Exact sum;
  for (std::size_t k = 0; k < 3; ++k) {
    result.plane[k] = cross(corner[(k + 1) % 3], corner[(k + 2) % 3]);
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += result.plane[k][axis];
  }
  const mpq_class det = dot(corner[0], result.plane[0]);
  result.orientation = sgn(det);
  if (result.orientation == 0) return result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t k = 0; k < 3; ++k) result.plane[k][axis] *= result.orientation;
    result.plane[3][axis] = sum[axis] / det;
  }
  return result;
}

// Evaluated with as many roundings as the bounds allow: in pieces, as for a block of pixels within a box.
float evaluated(const double (&in_double)[3], int x, int y) {
  const float plane[3] = {static_cast<float>(in_double[0]), static_cast<float>(in_double[1]),
                          static_cast<float>(in_double[2])};
  const int block_x = x / 4 * 4;
  const int block_y = y / 4 * 4;
  const float block =
      (plane[2] + plane[0] * static_cast<float>(block_x)) + plane[1] * static_cast<float>(block_y);
  return block + (plane[0] * static_cast<float>(x - block_x) + plane[1] * static_cast<float>(y - block_y));
}

// How much of the bounds was used, at most; and how often the filter was of use.
struct Attack {
  double edge_share = 0.0;
  double depth_share = 0.0;
  int certain = 0;
  int values = 0;
  int uncertain_values = 0;
};

// An edge's value in units of its ε is not told, but its largest coefficient tells the factor.
double scale_of(const double (&plane)[3], const Exact& exact, const Exact& at_origin) {
  const mpq_class true_value[3] = {exact[0], exact[1], dot(exact, at_origin)};
  int largest = 0;
  for (int k = 1; k < 3; ++k) {
    if (abs(true_value[k]) > abs(true_value[largest])) largest = k;
  }
  return mpq_class(mpq_class(plane[largest]) / true_value[largest]).get_d();
}

void check_offset(const OneTriangle& triangle, const OneSetUp& got, const ExactPlanes& exact,
                  double depth_scale, int x, int y, Attack& attack) {
  const Exact sample = {mpq_class(2 * (triangle.origin_i + x) + 1, 2),
                        mpq_class(2 * (triangle.origin_j + y) + 1, 2), 1};
  const Exact origin = {mpq_class(2 * triangle.origin_i + 1, 2), mpq_class(2 * triangle.origin_j + 1, 2), 1};
  for (int k = 0; k < 3; ++k) {
    const float value = evaluated(got.plane[k], x, y);
    const mpq_class want = dot(exact.plane[k], sample);
    ++attack.values;
    if (value >= 1.0F) {
      REQUIRE(want >= 0);
    } else if (value < -1.0F) {
      REQUIRE(want < 0);
    } else {
      ++attack.uncertain_values;
    }
    const double scale = scale_of(got.plane[k], exact.plane[k], origin);
    const double error = std::abs(mpq_class(mpq_class(double{value}) - want * mpq_class(scale)).get_d());
    attack.edge_share = std::max(attack.edge_share, error);
    // The factor is known to the relative error of a double coefficient.
    REQUIRE(error <= 1.0 + 1e-9 * std::abs(double{value}));
  }
  const float inverse_depth = evaluated(got.plane[3], x, y);
  if (!std::isfinite(inverse_depth)) {
    REQUIRE_FALSE(got.depth_error < 1e30);
    return;
  }
  const mpq_class error =
      abs(mpq_class(double{inverse_depth}) - dot(exact.plane[3], sample) * mpq_class(depth_scale));
  if (!std::isfinite(got.depth_error)) return;
  REQUIRE(error <= mpq_class(got.depth_error));
  attack.depth_share = std::max(attack.depth_share, mpq_class(error / mpq_class(got.depth_error)).get_d());
}

void attack_triangle(const View& view, const OneTriangle& triangle, std::string_view set, Attack& attack) {
  const lanes::RasterView raster = lanes::raster_view(view);
  OneSetUp got{};
  HWY_DISPATCH_TABLE(set_up_one)[lanes::dispatch_index(set)](raster, triangle, got);
  if (!got.certain) return;
  const ExactPlanes exact = exact_planes(view, triangle);
  REQUIRE(exact.orientation != 0);
  ++attack.certain;
  for (const int y : {0, 1, triangle.reach_y / 2, triangle.reach_y}) {
    for (const int x : {0, 3, triangle.reach_x / 2, triangle.reach_x}) {
      check_offset(triangle, got, exact, raster.depth_scale, std::min(x, triangle.reach_x), y, attack);
    }
  }
}

// What makes a triangle hard.
struct Trouble {
  std::string name;
  double scale = 1.0;       ///< of the scene
  double distance = 0.0;    ///< of the scene from the origin, in scene sizes
  double size = 0.1;        ///< of a triangle, in scene sizes
  double flatness = 1.0;    ///< the third corner's distance from the line through the others, in sizes
  double far_vertex = 0.0;  ///< where the third corner is, in scene sizes, if not 0
};

Attack attack_family(const Trouble& trouble, std::string_view set, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const auto vector = [&] { return glm::dvec3(any(random), any(random), any(random)); };
  Attack attack;
  Scene scene;
  scene.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  scene.triangles = {{{0, 1, 2}, 0, no_material}};
  for (std::uint64_t round = 0; round < cases(150); ++round) {
    const glm::dvec3 centre = trouble.scale * trouble.distance * vector();
    Camera camera;
    camera.eye = centre + trouble.scale * 2.5 * vector();
    camera.target = centre + trouble.scale * 0.1 * vector();
    camera.vertical_fov_degrees = 20.0 + 40.0 * (any(random) + 1.0);
    const int width = 16 << (random() % 8);
    const int height = 1 + static_cast<int>(random() % 2000);
    const View view = make_view(scene, camera, width, height, 0.01 * trouble.scale, 100.0 * trouble.scale);
    OneTriangle triangle;
    const glm::dvec3 p = centre + trouble.scale * vector();
    const glm::dvec3 along = trouble.scale * trouble.size * vector();
    const glm::dvec3 across = trouble.scale * trouble.size * trouble.flatness * vector();
    glm::dvec3 third = p + 0.4 * along + across;
    if (trouble.far_vertex != 0.0) third = centre + trouble.scale * trouble.far_vertex * vector();
    triangle.corner = {glm::vec3(p), glm::vec3(p + along), glm::vec3(third)};
    std::swap(triangle.corner[0], triangle.corner[random() % 3]);
    triangle.reach_x = 3 + 4 * static_cast<int>(random() % 16);
    triangle.reach_y = 3 + 4 * static_cast<int>(random() % 16);
    // The origin is put near the middle of an edge, where values are small, or anywhere.
    const glm::dvec4 middle = view.clip_from_world * glm::dvec4(p + 0.5 * along, 1.0);
    const double x = (1.0 + middle.x / middle.w) * width / 2.0 - 2.0;
    const double y = (1.0 - middle.y / middle.w) * height / 2.0 - 2.0;
    const bool seen = middle.w > 0.0 && x > 0.0 && x < width && y > 0.0 && y < height;
    triangle.origin_i =
        seen ? static_cast<int>(x) : static_cast<int>(random() % static_cast<unsigned>(width));
    triangle.origin_j =
        seen ? static_cast<int>(y) : static_cast<int>(random() % static_cast<unsigned>(height));
    attack_triangle(view, triangle, set, attack);
  }
  return attack;
}

const std::array troubles = {
    Trouble{.name = "plain"},
    Trouble{.name = "large", .size = 3.0},
    Trouble{.name = "tiny triangles", .size = 1e-4},
    Trouble{.name = "a tiny scene", .scale = 1e-30},
    Trouble{.name = "denormals", .scale = 1e-43, .size = 1.0},
    Trouble{.name = "a huge scene", .scale = 1e30},
    Trouble{.name = "needles", .size = 1.0, .flatness = 1e-6},
    Trouble{.name = "far from the origin", .distance = 3e4},
    Trouble{.name = "very far from the origin", .distance = 1e6, .size = 1.0},
    Trouble{.name = "one far vertex", .far_vertex = 1e6},
    Trouble{.name = "one vertex out of all reach", .far_vertex = 1e30},
};

}  // namespace

TEST_CASE("lanes: what the filter is certain of is true in exact arithmetic, whatever the triangle") {
  for (const std::string_view set : lanes::instruction_sets()) {
    std::uint64_t seed = 1;
    for (const Trouble& trouble : troubles) {
      CAPTURE(set);
      CAPTURE(trouble.name);
      attack_family(trouble, set, ++seed);
    }
  }
}

TEST_CASE("lanes: the filter's bounds are neither far from what happens nor of no use") {
  for (const std::string_view set : lanes::instruction_sets()) {
    CAPTURE(set);
    const Attack plain = attack_family({.name = "plain", .size = 1.0}, set, 99);
    CHECK(plain.edge_share > 0.1);
    CHECK(plain.depth_share > 0.1);
    CHECK(1000 * plain.uncertain_values <= plain.values);
    for (const double distance : {0.0, 3e4}) {
      const Attack attack = attack_family({.name = "moved", .distance = distance}, set, 7);
      CHECK(attack.certain > static_cast<int>(cases(150)) * 99 / 100);
    }
  }
}

}  // namespace hsr::test

#endif
