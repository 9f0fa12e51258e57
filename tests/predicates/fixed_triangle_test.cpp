#include "predicates/fixed_triangle.h"

#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <random>

#include "predicates/dyadic.h"
#include "predicates/whole_corner.h"
#include "support/effort.h"
#include "support/small_scenes.h"
#include "view/screen_triangles.h"

namespace {

// The sign of an edge in numbers of any size.
int sign_of_edge(const hsr::Projection& projection, const hsr::Scene& scene, std::size_t k, double a,
                 double b) {
  std::array<hsr::Homogeneous<hsr::Dyadic>, 3> corner;
  for (std::size_t corner_index = 0; corner_index < 3; ++corner_index) {
    corner[corner_index] = hsr::clip_from_world<hsr::Dyadic>(projection, scene.positions[corner_index]);
  }
  return at_sample(hsr::homogeneous_triangle(projection, corner).edge[k], a, b).sign();
}

// Checks every edge at some samples; whether fixed width was enough.
bool check(const hsr::View& view, std::mt19937_64& random) {
  const hsr::Projection projection = projection_of(view);
  const std::optional<hsr::FixedProjection> fixed = hsr::fixed_projection(projection);
  if (!fixed) return false;
  const std::optional<hsr::FixedTriangle> triangle = hsr::FixedTriangle::make(*fixed, *view.scene, 0);
  if (!triangle) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    for (int round = 0; round < 4; ++round) {
      const double a =
          hsr::centre_a(view.width, static_cast<int>(random() % static_cast<unsigned>(view.width)));
      const double b =
          hsr::centre_b(view.height, static_cast<int>(random() % static_cast<unsigned>(view.height)));
      REQUIRE(triangle->edge_sign(k, a, b) == sign_of_edge(projection, *view.scene, k, a, b));
    }
  }
  return true;
}

}  // namespace

TEST_CASE("predicates: signs in numbers of fixed width are those in numbers of any size") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<float> any(-1.0F, 1.0F);
  for (const int digits : {1, 4, 24, 50}) {  // by how many binary digits the positions' sizes differ
    int enough = 0;
    constexpr int rounds = 60;
    for (int round = 0; round < rounds; ++round) {
      const auto coordinate = [&] {
        const int exponent = static_cast<int>(random() % static_cast<unsigned>(digits)) - digits / 2;
        return std::ldexp(any(random), exponent);
      };
      const auto corner = [&] { return glm::vec3(coordinate(), coordinate(), coordinate()); };
      const hsr::Scene scene = hsr::test::scene_of({{corner(), corner(), corner()}});
      const int width = round % 3 == 0 ? 32768 : 640;
      const hsr::Camera camera = {.eye = glm::dvec3(3.0, 2.0, 4.0) + glm::dvec3(corner())};
      if (check(hsr::make_view(scene, camera, width, 480, 0.1, 100.0), random)) ++enough;
    }
    CAPTURE(digits);
    // Positions of like sizes never need more; wildly different ones may.
    if (digits <= 24) CHECK(enough == rounds);
  }
}

TEST_CASE("predicates: numbers of fixed width find exact zeros and refuse what they cannot hold") {
  // At this distance pixel centres are at odd halves: two edges run through centres.
  const hsr::Scene aligned =
      hsr::test::scene_of({{{{-1.5F, -1.5F, 0.0F}, {1.5F, -1.5F, 0.0F}, {1.5F, 1.5F, 0.0F}}}});
  const hsr::View view = hsr::test::front_view(aligned, 8, 8, 4.0);
  const hsr::Projection projection = projection_of(view);
  const std::optional<hsr::FixedProjection> fixed = hsr::fixed_projection(projection);
  REQUIRE(fixed);
  const std::optional<hsr::FixedTriangle> triangle = hsr::FixedTriangle::make(*fixed, aligned, 0);
  REQUIRE(triangle);
  int zeros = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    for (int j = 0; j < 8; ++j) {
      for (int i = 0; i < 8; ++i) {
        const double a = hsr::centre_a(8, i);
        const double b = hsr::centre_b(8, j);
        const int sign = triangle->edge_sign(k, a, b);
        REQUIRE(sign == sign_of_edge(projection, aligned, k, a, b));
        zeros += sign == 0 ? 1 : 0;
      }
    }
  }
  CHECK(zeros == 24);

  const hsr::Scene wild =
      hsr::test::scene_of({{{{1e30F, 0.0F, 0.0F}, {1e-30F, 1.0F, 0.0F}, {0.0F, 0.0F, 1.0F}}}});
  CHECK_FALSE(hsr::FixedTriangle::make(*fixed, wild, 0));
}

TEST_CASE("predicates: corners on pixel centres are found, and settle edges as numbers of any size do") {
  std::mt19937_64 random(8);
  // At this distance a centre is at every odd half, so a half in three coordinates is no centre.
  std::uniform_int_distribution<int> place(-4, 3);
  int settled = 0;
  int zeros = 0;
  for (int round = 0; round < 100; ++round) {
    const auto coordinate = [&] {
      return static_cast<float>(place(random)) + (round % 4 == 3 ? 0.25F : 0.5F);
    };
    const auto corner = [&] {
      return glm::vec3(coordinate(), static_cast<float>(place(random)) + 0.5F, 0.0F);
    };
    const hsr::Scene scene = hsr::test::scene_of({{corner(), corner(), corner()}});
    const hsr::View view = hsr::test::front_view(scene, 8, 8, 4.0);
    const hsr::Projection projection = projection_of(view);
    const hsr::FixedProjection fixed = *hsr::fixed_projection(projection);
    std::array<hsr::WholeCorner, 3> whole;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec3& point = scene.positions[scene.triangles[0].corners[k]];
      whole[k] = hsr::whole_corner(projection, fixed, point);
      REQUIRE(whole[k].b == static_cast<std::int64_t>(2.0F * point.y));
      REQUIRE(whole[k].a.has_value() == (round % 4 != 3));
    }
    for (std::size_t k = 0; k < 3; ++k) {
      for (int pixel = 0; pixel < 64; ++pixel) {
        const double a = hsr::centre_a(8, pixel % 8);
        const double b = hsr::centre_b(8, pixel / 8);
        const std::optional<int> sign =
            hsr::edge_sign(whole[(k + 1) % 3], whole[(k + 2) % 3], static_cast<std::int64_t>(a),
                           static_cast<std::int64_t>(b));
        if (!sign) continue;
        ++settled;
        zeros += *sign == 0 ? 1 : 0;
        REQUIRE(*sign == sign_of_edge(projection, scene, k, a, b));
      }
    }
  }
  CHECK(settled > 75 * 3 * 64);  // all where both coordinates are whole, some where one is
  CHECK(zeros > 1000);
}

TEST_CASE("predicates: a corner beside a pixel centre by the least that a float can say is not on it") {
  const float beside = std::nextafter(0.5F, 1.0F);
  const hsr::Scene scene =
      hsr::test::scene_of({{{{beside, 0.5F, 0.0F}, {1.5F, -0.5F, 0.0F}, {1.5F, 1.5F, 0.0F}}}});
  const hsr::View view = hsr::test::front_view(scene, 8, 8, 4.0);
  const hsr::Projection projection = projection_of(view);
  const hsr::WholeCorner whole =
      hsr::whole_corner(projection, *hsr::fixed_projection(projection), scene.positions[0]);
  CHECK_FALSE(whole.a.has_value());
  CHECK(whole.b == 1);
}
