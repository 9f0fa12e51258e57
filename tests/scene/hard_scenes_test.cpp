#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "exact/exact_answer.h"
#include "scene/catalog.h"
#include "view/view.h"

namespace {

using hsr::make_built_in_scene;
using hsr::Scene;
using Order = std::set<std::pair<std::uint32_t, std::uint32_t>>;

// All pairs (p, q) such that p is nearest at some pixel that q covers too, farther away. A painter has
// to paint p after q.
Order painting_order(const Scene& scene, int width, int height) {
  const hsr::View view = hsr::make_view(scene, *scene.camera, width, height);
  const hsr::exact::ExactAnswer exact(view, 1);
  Order order;
  for (int row = 0; row < height; ++row) {
    const hsr::exact::DepthLists lists = exact.depth_lists(row, row + 1);
    for (std::size_t pixel = 0; pixel + 1 < lists.begin.size(); ++pixel) {
      bool tied = true;
      for (std::size_t k = lists.begin[pixel] + 1; k < lists.begin[pixel + 1]; ++k) {
        tied = tied && lists.fragments[k].tied;
        if (!tied) order.insert({lists.fragments[lists.begin[pixel]].id, lists.fragments[k].id});
      }
    }
  }
  return order;
}

// The triangles that no order of painting can satisfy: what is left after taking away, again and
// again, all that nothing has to be painted after, or before.
std::set<std::uint32_t> cyclic_triangles(Order order) {
  for (;;) {
    std::set<std::uint32_t> above;
    std::set<std::uint32_t> below;
    for (const auto& [p, q] : order) {
      above.insert(p);
      below.insert(q);
    }
    const auto is_loose = [&](const auto& pair) {
      return !below.contains(pair.first) || !above.contains(pair.second);
    };
    if (std::erase_if(order, is_loose) == 0) return above;
  }
}

// A point in units of 2^-10, so that the tests below are exact in whole numbers.
struct Point {
  std::int64_t x, y, z;
};

Point point(const glm::dvec3& p) {
  const glm::dvec3 scaled = p * 1024.0;
  REQUIRE((scaled.x == std::floor(scaled.x) && scaled.y == std::floor(scaled.y) &&
           scaled.z == std::floor(scaled.z)));
  return {static_cast<std::int64_t>(scaled.x), static_cast<std::int64_t>(scaled.y),
          static_cast<std::int64_t>(scaled.z)};
}

// The sign says on which side of the plane through a, b and c the point d lies.
std::int64_t side(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point u{b.x - a.x, b.y - a.y, b.z - a.z};
  const Point v{c.x - a.x, c.y - a.y, c.z - a.z};
  const Point w{d.x - a.x, d.y - a.y, d.z - a.z};
  return w.x * (u.y * v.z - u.z * v.y) + w.y * (u.z * v.x - u.x * v.z) + w.z * (u.x * v.y - u.y * v.x);
}

using Corners = std::array<Point, 3>;

// True if the open segment from p to q meets the triangle, its boundary included, from side to side.
bool crosses(const Point& p, const Point& q, const Corners& t) {
  const auto sign = [](std::int64_t value) { return value > 0 ? 1 : value < 0 ? -1 : 0; };
  if (sign(side(t[0], t[1], t[2], p)) * sign(side(t[0], t[1], t[2], q)) >= 0) return false;
  const int a = sign(side(p, q, t[0], t[1]));
  const int b = sign(side(p, q, t[1], t[2]));
  const int c = sign(side(p, q, t[2], t[0]));
  return std::min({a, b, c}) >= 0 || std::max({a, b, c}) <= 0;
}

Corners corners(const Scene& scene, std::uint32_t id) {
  const auto& [a, b, c] = scene.triangles[id].corners;
  return {point(scene.positions[a]), point(scene.positions[b]), point(scene.positions[c])};
}

bool intersect(const Corners& s, const Corners& t) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (crosses(s[k], s[(k + 1) % 3], t) || crosses(t[k], t[(k + 1) % 3], s)) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("scene: the three bars are exact parallelograms and do not touch each other") {
  const Scene scene = *make_built_in_scene("three-bars");
  REQUIRE(scene.triangles.size() == 6);
  for (std::size_t bar = 0; bar < 3; ++bar) {
    const glm::vec3* corner = &scene.positions[4 * bar];
    CHECK(corner[0] + corner[2] == corner[1] + corner[3]);
  }
  for (std::uint32_t p = 0; p < 6; ++p) {
    for (std::uint32_t q = p + 1; q < 6; ++q) {
      if (scene.triangles[p].face == scene.triangles[q].face) continue;
      CAPTURE(p);
      CAPTURE(q);
      CHECK(!intersect(corners(scene, p), corners(scene, q)));
    }
  }
}

TEST_CASE("scene: each of the three bars hides points of the next and none of the one before") {
  const Scene scene = *make_built_in_scene("three-bars");
  const Point eye = point(scene.camera->eye);
  // Counts those of a grid of points of a bar that the other bar hides from the eye.
  const auto hidden = [&](std::uint32_t bar, std::uint32_t by) {
    const glm::vec3* corner = &scene.positions[std::size_t{4} * bar];
    const glm::dvec3 origin = corner[0];
    const glm::dvec3 across = glm::dvec3(corner[1]) - origin;
    const glm::dvec3 along = glm::dvec3(corner[3]) - origin;
    int count = 0;
    for (int s = 0; s <= 4; ++s) {
      for (int t = 0; t <= 16; ++t) {
        const Point at = point(origin + across * (s / 4.0) + along * (t / 16.0));
        const bool is_hidden =
            crosses(eye, at, corners(scene, 2 * by)) || crosses(eye, at, corners(scene, 2 * by + 1));
        count += is_hidden ? 1 : 0;
      }
    }
    return count;
  };
  for (std::uint32_t bar = 0; bar < 3; ++bar) {
    CAPTURE(bar);
    CHECK(hidden((bar + 1) % 3, bar) >= 5);
    CHECK(hidden(bar, (bar + 1) % 3) == 0);
  }
}

TEST_CASE("scene: no order of painting the triangles of three-bars or crossing is right") {
  for (const auto& [width, height] : {std::pair(640, 480), std::pair(1280, 720)}) {
    CAPTURE(width);
    CHECK(cyclic_triangles(painting_order(*make_built_in_scene("three-bars"), width, height)).size() == 6);
    const Order order = painting_order(*make_built_in_scene("crossing"), width, height);
    CHECK(order.size() == 6);  // each pair in both directions
    CHECK(cyclic_triangles(order).size() == 3);
  }
}

TEST_CASE("scene: the woven cloth has cycles everywhere and no two triangles in both orders") {
  const Order order = painting_order(*make_built_in_scene("woven:4"), 320, 240);
  CHECK(std::ranges::none_of(order, [&](const auto& pair) {
    return order.contains({pair.second, pair.first});
  }));
  CHECK(cyclic_triangles(order).size() >= 24);
}

TEST_CASE("scene: box and cube can be painted") {
  for (const char* name : {"box", "cube", "big-and-small"}) {
    CAPTURE(name);
    CHECK(cyclic_triangles(painting_order(*make_built_in_scene(name), 320, 240)).empty());
  }
}

TEST_CASE("scene: whole boards of coplanar lie in one plane, and most of their pixels are ties") {
  const Scene scene = *make_built_in_scene("coplanar");
  for (std::uint32_t id = 0; id < scene.triangles.size(); ++id) {
    CAPTURE(id);
    const std::uint32_t first_of_board = id / 6 * 6;
    const Corners plane = corners(scene, first_of_board);
    for (const Point& corner : corners(scene, id)) CHECK(side(plane[0], plane[1], plane[2], corner) == 0);
  }
  const hsr::View view = hsr::make_view(scene, *scene.camera, 320, 240);
  const hsr::exact::DepthLists lists = hsr::exact::ExactAnswer(view, 1).depth_lists(0, 240);
  std::size_t ties = 0;
  for (const hsr::exact::Fragment& fragment : lists.fragments) ties += fragment.tied ? 1U : 0U;
  CHECK(ties > 5000);
}

TEST_CASE("scene: hair-apart keeps its gap however small") {
  for (const int k : {4, 18, 60, 120}) {
    CAPTURE(k);
    const Scene scene = *make_built_in_scene("hair-apart:" + std::to_string(k));
    const glm::dvec3 sight = scene.camera->eye - scene.camera->target;
    const double distance = std::sqrt(sight.x * sight.x + sight.y * sight.y + sight.z * sight.z);
    const auto gap = static_cast<float>(std::ldexp(distance, -k));
    CHECK(gap > 0.0F);
    // Five faces a board: two patches, the board, two patches.
    for (std::size_t face = 0; face < 15; ++face) {
      const auto axis = static_cast<int>(face / 5);
      const bool is_board = face % 5 == 2;
      for (std::size_t corner = 0; corner < 4; ++corner) {
        CHECK(scene.positions[4 * face + corner][axis] == (is_board ? 0.0F : gap));
      }
    }
  }
}

TEST_CASE("scene: all corners of aligned-grid are seen exactly on pixel centres") {
  const Scene scene = *make_built_in_scene("aligned-grid[n=20,step=8,height=512]");
  const hsr::View view = hsr::make_view(scene, *scene.camera, 512, 512);
  for (const glm::vec3& position : scene.positions) {
    // The matrix has whole entries here, so nothing is rounded.
    const glm::dvec4 clip = view.clip_from_world * glm::dvec4(position, 1.0);
    const double i = (clip.x * 512.0 / clip.w + 511.0) / 2.0;
    const double j = (511.0 - clip.y * 512.0 / clip.w) / 2.0;
    REQUIRE(i == std::floor(i));
    REQUIRE(j == std::floor(j));
  }
  for (const int size : {511, 720}) {
    CAPTURE(size);
    const Scene other = *make_built_in_scene("aligned-grid[n=5,height=" + std::to_string(size) + "]");
    const hsr::View square = hsr::make_view(other, *other.camera, size, size);
    CHECK(square.clip_from_world[0][0] == 4.0);
    CHECK(square.clip_from_world[1][1] == 4.0);
    CHECK((other.positions[0].x == std::floor(other.positions[0].x)) == (size % 2 == 1));
  }
}

TEST_CASE("scene: the room surrounds the eye, and triangles pass through the eye's plane") {
  const Scene scene = *make_built_in_scene("room");
  const hsr::View view = hsr::make_view(scene, *scene.camera, 320, 240);
  std::size_t through = 0;
  std::size_t behind = 0;
  for (const hsr::Triangle& triangle : scene.triangles) {
    int before = 0;
    for (const std::uint32_t corner : triangle.corners) {
      before += (view.clip_from_world * glm::dvec4(scene.positions[corner], 1.0)).w > 0.0 ? 1 : 0;
    }
    through += before == 1 || before == 2 ? 1U : 0U;
    behind += before == 0 ? 1U : 0U;
  }
  CHECK(through >= 8);
  CHECK(behind >= 2);
  CHECK(hsr::exact::ExactAnswer(view, 1).nearest(1).covered == 320U * 240U);
}

TEST_CASE("scene: the list of the middle pixel of layers is as long as the scene") {
  const Scene scene = *make_built_in_scene("layers:100");
  const hsr::View view = hsr::make_view(scene, *scene.camera, 64, 64);
  const hsr::exact::DepthLists lists = hsr::exact::ExactAnswer(view, 1).depth_lists(32, 33);
  std::set<std::uint32_t> faces;
  for (std::size_t k = lists.begin[32]; k < lists.begin[33]; ++k) {
    faces.insert(scene.triangles[lists.fragments[k].id].face);
  }
  CHECK(faces.size() == 100);
}

TEST_CASE("scene: all triangles of the fan meet in the middle of a picture of odd size") {
  const Scene scene = *make_built_in_scene("fan:40");
  const hsr::View view = hsr::make_view(scene, *scene.camera, 33, 33);
  const hsr::exact::DepthLists lists = hsr::exact::ExactAnswer(view, 1).depth_lists(16, 17);
  CHECK(lists.begin[17] - lists.begin[16] == 40);
  for (std::size_t k = lists.begin[16] + 1; k < lists.begin[17]; ++k) CHECK(lists.fragments[k].tied);
}
