#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <string>

#include "scene/catalog.h"
#include "support/mesh_edges.h"

namespace {

using hsr::make_built_in_scene;
using hsr::Scene;
using hsr::test::count_edges;
using hsr::test::MeshEdges;

// FNV-1a over the bits of all coordinates.
std::uint64_t position_hash(const Scene& scene) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const glm::vec3& position : scene.positions) {
    for (int k = 0; k < 3; ++k) {
      const auto bits = std::bit_cast<std::uint32_t>(position[k]);
      for (unsigned shift = 0; shift < 32; shift += 8)
        hash = (hash ^ ((bits >> shift) & 0xFFU)) * 0x100000001b3U;
    }
  }
  return hash;
}

bool same(const glm::vec3& a, const glm::vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

}  // namespace

TEST_CASE("scene: box and cube are closed, outward and of six faces with two triangles each") {
  for (const char* name : {"box", "cube"}) {
    CAPTURE(name);
    const Scene scene = *make_built_in_scene(name);
    CHECK(scene.triangles.size() == 12);
    CHECK(scene.positions.size() == 8);
    for (std::uint32_t k = 0; k < 12; ++k) CHECK(scene.triangles[k].face == k / 2);
    CHECK(count_edges(scene).closed());
    CHECK(count_edges(scene).shared == 18);
  }
  CHECK(hsr::test::signed_volume(*make_built_in_scene("box")) == doctest::Approx(3.0 * 1.8 * 2.0));
  CHECK(hsr::test::signed_volume(*make_built_in_scene("cube")) == 8.0);
}

TEST_CASE("scene: in the box a hidden face follows the visible one that it lies behind") {
  const Scene scene = *make_built_in_scene("box");
  const auto normal_z = [&](std::size_t face) {
    const auto& [a, b, c] = scene.triangles[2 * face].corners;
    const glm::vec3 u = scene.positions[b] - scene.positions[a];
    const glm::vec3 v = scene.positions[c] - scene.positions[a];
    return u.x * v.y - u.y * v.x;
  };
  CHECK(normal_z(2) > 0.0F);  // towards the eye
  CHECK(normal_z(3) < 0.0F);  // away from it, yet later in the file
}

TEST_CASE("scene: every triangle of the duplicate cube is there twice, with vertices of its own") {
  const Scene scene = *make_built_in_scene("duplicate-cube");
  REQUIRE(scene.triangles.size() == 24);
  for (std::size_t k = 0; k < 12; ++k) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t first = scene.triangles[k].corners[corner];
      const std::uint32_t second = scene.triangles[k + 12].corners[corner];
      CHECK(first != second);
      CHECK(same(scene.positions[first], scene.positions[second]));
    }
  }
}

TEST_CASE("scene: the bumpy sphere has 12 n² triangles, is closed and turned outward for every n") {
  for (const std::size_t n : {1U, 2U, 3U, 7U, 76U}) {
    CAPTURE(n);
    const Scene scene = *make_built_in_scene("bumpy-sphere:" + std::to_string(n));
    const std::size_t squares = n * n;
    CHECK(scene.triangles.size() == 12 * squares);
    CHECK(scene.positions.size() == 6 * squares + 2);
    const MeshEdges edges = count_edges(scene);
    CHECK(edges.closed());
    CHECK(edges.shared == 18 * squares);
    CHECK(scene.triangles.back().face == 6 * squares - 1);
    CHECK(hsr::test::signed_volume(scene) > (n == 1 ? 1.0 : 2.5));
  }
  CHECK(make_built_in_scene("bumpy-sphere")->triangles.size() == 69312);
}

TEST_CASE("scene: the bumpy sphere's corners have the radius of its formula") {
  const Scene scene = *make_built_in_scene("bumpy-sphere:6");
  for (const glm::vec3& position : scene.positions) {
    const glm::dvec3 p = position;
    const double radius = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    const glm::dvec3 d = p / radius;
    const double expected = 1.0 +
                            0.06 * std::sin(9 * d.x + 1) * std::sin(11 * d.y + 2) * std::sin(10 * d.z + 3) +
                            0.015 * std::sin(37 * d.x) * std::sin(41 * d.y) * std::sin(43 * d.z);
    CHECK(radius == doctest::Approx(expected).epsilon(1e-6));
  }
}

TEST_CASE("scene: the soup is the same on every machine") {
  CHECK(position_hash(*make_built_in_scene("soup:1000")) == 14368865398972113225U);
  CHECK(position_hash(*make_built_in_scene("big-soup")) == 2409765215634870477U);
}

TEST_CASE("scene: a longer soup begins with the shorter one, and inside-soup is the same soup") {
  const Scene shorter = *make_built_in_scene("soup:50");
  const Scene longer = *make_built_in_scene("soup:60");
  const Scene inside = *make_built_in_scene("inside-soup:50");
  CHECK(std::equal(shorter.positions.begin(), shorter.positions.end(), longer.positions.begin(), same));
  CHECK(std::equal(shorter.positions.begin(), shorter.positions.end(), inside.positions.begin(), same));
}

TEST_CASE("scene: triangles of the soup lie in its box and are as small as they should be") {
  const Scene scene = *make_built_in_scene("soup:2000");
  for (const hsr::Triangle& triangle : scene.triangles) {
    const glm::vec3 a = scene.positions[triangle.corners[0]];
    const glm::vec3 b = scene.positions[triangle.corners[1]];
    REQUIRE(std::abs(a.x) <= 3.15F);
    REQUIRE(std::abs(a.y) <= 1.85F);
    REQUIRE(std::abs(a.z) <= 1.15F);
    REQUIRE(std::hypot(a.x - b.x, a.y - b.y, a.z - b.z) <= 0.2961F);
  }
}

TEST_CASE("scene: far away the sphere's corners lie on a coarse grid") {
  const Scene scene = *make_built_in_scene("far-away:20");
  std::set<float> values;
  for (const glm::vec3& position : scene.positions) values.insert(position.x);
  for (const float value : values) CHECK(std::fmod(value, value < 1048576.0F ? 0.0625F : 0.125F) == 0.0F);
  CHECK(values.size() > 10);
  CHECK(values.size() < 30);
}

TEST_CASE("scene: one corner makes the box of one-cell large, and all others are close together") {
  const Scene scene = *make_built_in_scene("one-cell:5000");
  std::size_t far_corners = 0;
  for (const glm::vec3& p : scene.positions) far_corners += std::hypot(p.x, p.y, p.z) > 10.0F ? 1U : 0U;
  CHECK(far_corners == 1);
}

TEST_CASE("scene: nine of ten spheres are behind the wall") {
  const Scene scene = *make_built_in_scene("behind-a-wall:4");
  CHECK(scene.triangles.size() == 10 * 12 * 16 + 2);
  std::size_t behind = 0;
  for (const hsr::Triangle& triangle : scene.triangles) {
    behind += scene.positions[triangle.corners[0]].z < 0.0F ? 1U : 0U;
  }
  CHECK(behind == 9 * 12 * 16);
}

TEST_CASE("scene: the terrain is one sheet") {
  const MeshEdges edges = count_edges(*make_built_in_scene("terrain:20"));
  CHECK(edges.boundary == 4 * 20);
  CHECK(edges.other == 0);
}
