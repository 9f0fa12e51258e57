#include "predicates/sample_predicates.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "predicates/pixel_box.h"
#include "support/rational_answer.h"
#include "support/small_scenes.h"
#include "view/screen_triangles.h"

namespace {

using hsr::test::RationalFragment;

std::optional<hsr::SampleTriangle> set_up(const hsr::View& view, hsr::SamplePredicates& predicates,
                                          std::uint32_t id, hsr::PixelBox& box) {
  const hsr::Projection projection = hsr::projection_of(view);
  std::array<hsr::Homogeneous<hsr::Bounded>, 3> corner;
  for (std::size_t k = 0; k < 3; ++k) {
    corner[k] = hsr::clip_from_world<hsr::Bounded>(
        projection, view.scene->positions[view.scene->triangles[id].corners[k]]);
  }
  box = hsr::pixel_box(projection, corner).box;
  return predicates.set_up(id, corner);
}

bool within(const hsr::PixelBox& box, int i, int j) {
  return i >= box.first_i && i <= box.last_i && j >= box.first_j && j <= box.last_j;
}

// Asks everything about every triangle and pair of triangles at every pixel.
void check_all_questions(const hsr::View& view) {
  const hsr::test::RationalAnswer rationals(view);
  hsr::SamplePredicates predicates(hsr::projection_of(view), *view.scene);
  const auto count = static_cast<std::uint32_t>(view.scene->triangles.size());
  std::vector<std::optional<hsr::SampleTriangle>> triangles(count);
  std::vector<hsr::PixelBox> boxes(count);
  for (std::uint32_t id = 0; id < count; ++id) triangles[id] = set_up(view, predicates, id, boxes[id]);

  for (int j = 0; j < view.height; ++j) {
    for (int i = 0; i < view.width; ++i) {
      CAPTURE(i);
      CAPTURE(j);
      const double a = hsr::centre_a(view.width, i);
      const double b = hsr::centre_b(view.height, j);
      const std::vector<RationalFragment> list = rationals.depth_list(i, j);
      for (std::uint32_t id = 0; id < count; ++id) {
        CAPTURE(id);
        const auto found = std::ranges::find(list, id, &RationalFragment::id);
        const bool covered = found != list.end();
        REQUIRE((triangles[id] && predicates.covers(*triangles[id], a, b)) == covered);
        if (!covered) continue;
        REQUIRE(within(boxes[id], i, j));
        // The nearest float: no neighbour is nearer to the exact depth.
        const float depth = predicates.nearest_float_depth(*triangles[id], a, b);
        if (std::isinf(std::nextafter(depth, INFINITY))) continue;
        const mpq_class error = abs(mpq_class(double{depth}) - found->depth);
        REQUIRE(error <= abs(mpq_class(double{std::nextafter(depth, INFINITY)}) - found->depth));
        REQUIRE(error <= abs(mpq_class(double{std::nextafter(depth, 0.0F)}) - found->depth));
      }
      for (const RationalFragment& p : list) {
        for (const RationalFragment& q : list) {
          REQUIRE(predicates.compare_depth(*triangles[p.id], *triangles[q.id], a, b) ==
                  sgn(p.depth - q.depth));
        }
      }
    }
  }
}

}  // namespace

TEST_CASE("predicates: coverage, order, nearest float and boxes agree with rationals on troublesome scenes") {
  for (std::uint64_t seed = 500; seed < 530; ++seed) {
    CAPTURE(seed);
    const hsr::Scene scene = hsr::test::troublesome_scene(seed, 4 + static_cast<int>(seed % 12));
    check_all_questions(hsr::test::front_view(scene, 8, 8, 4.0, 0.5, 5.5));
  }
}

TEST_CASE("predicates: they agree with rationals at the ends of the float range") {
  for (const float scale : {1e-44F, 1e-38F, 1e30F, 1.2e37F}) {
    hsr::Scene scene = hsr::test::troublesome_scene(9, 10);
    for (glm::vec3& position : scene.positions) position *= scale;
    hsr::Camera camera;
    camera.eye = {0.0, 0.0, 4.0 * double{scale}};
    camera.vertical_fov_degrees = 90.0;
    CAPTURE(scale);
    check_all_questions(hsr::make_view(scene, camera, 6, 6));
  }
}

TEST_CASE("predicates: they agree with rationals far from the origin") {
  hsr::Scene scene = hsr::test::troublesome_scene(11, 12);
  for (glm::vec3& position : scene.positions) position += glm::vec3(30000.0F, -20000.0F, 50000.0F);
  hsr::Camera camera;
  camera.target = {30000.0, -20000.0, 50000.0};
  camera.eye = camera.target + glm::dvec3(0.0, 0.0, 4.0);
  camera.vertical_fov_degrees = 90.0;
  check_all_questions(hsr::make_view(scene, camera, 8, 8));
}

TEST_CASE("predicates: the filter settles nearly everything on an ordinary scene") {
  const hsr::Scene scene = hsr::test::scene_of({
      {{{-1.1F, -1.3F, 0.2F}, {1.7F, -1.2F, 0.1F}, {0.3F, 1.9F, -0.4F}}},
      {{{-1.3F, -1.1F, -0.2F}, {1.2F, -1.7F, 0.3F}, {0.1F, 1.3F, 0.4F}}},
  });
  const hsr::View view = hsr::test::front_view(scene, 64, 64, 4.0);
  hsr::SamplePredicates predicates(hsr::projection_of(view), scene);
  hsr::PixelBox box;
  const auto p = set_up(view, predicates, 0, box);
  const auto q = set_up(view, predicates, 1, box);
  REQUIRE(p);
  REQUIRE(q);
  for (int j = 0; j < 64; ++j) {
    for (int i = 0; i < 64; ++i) {
      const double a = hsr::centre_a(64, i);
      const double b = hsr::centre_b(64, j);
      if (predicates.covers(*p, a, b) && predicates.covers(*q, a, b)) predicates.compare_depth(*p, *q, a, b);
    }
  }
  CHECK(predicates.exact_evaluations() == 0);
}
