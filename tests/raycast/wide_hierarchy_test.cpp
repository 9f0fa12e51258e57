#include "raycast/wide_hierarchy.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "raycast/morton_cuts.h"
#include "raycast/world_area.h"
#include "scene/catalog.h"
#include "support/small_scenes.h"

namespace {

using Hierarchy = hsr::WideHierarchy;

// The triangles below a child, after checking that its box holds them.
std::vector<std::uint32_t> checked_triangles(const hsr::Scene& scene, const Hierarchy& hierarchy,
                                             const Hierarchy::Node& parent, std::size_t place) {
  std::vector<std::uint32_t> ids;
  const std::uint32_t child = parent.child[place];
  if (hsr::WideTopology::is_leaf(child)) {
    const Hierarchy::Leaf& leaf = hierarchy.leaves()[hsr::WideTopology::leaf_index(child)];
    REQUIRE(leaf.count >= 1);
    REQUIRE(leaf.count <= Hierarchy::width);
    ids.assign(leaf.id.begin(), leaf.id.begin() + leaf.count);
  } else {
    const Hierarchy::Node& node = hierarchy.nodes()[child];
    for (std::size_t k = 0; k < Hierarchy::width && node.child[k] != hsr::WideTopology::no_child; ++k) {
      const std::vector<std::uint32_t> below = checked_triangles(scene, hierarchy, node, k);
      ids.insert(ids.end(), below.begin(), below.end());
    }
  }
  for (const std::uint32_t id : ids) {
    for (const std::uint32_t corner : scene.triangles[id].corners) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto component = static_cast<glm::length_t>(axis);
        const double exact =
            double{scene.positions[corner][component]} - double{hierarchy.reference()[component]};
        REQUIRE(parent.border[0][axis][place] <= exact);
        REQUIRE(exact <= parent.border[1][axis][place]);
      }
    }
  }
  return ids;
}

// Every triangle with an area is in one leaf, and boxes hold what is below them.
void check_hierarchy(const hsr::Scene& scene, const Hierarchy& hierarchy) {
  const std::vector<std::uint32_t> wanted = hsr::triangles_with_area(scene, 1);
  REQUIRE(hierarchy.empty() == wanted.empty());
  if (wanted.empty()) return;
  std::vector<std::uint32_t> found;
  const Hierarchy::Node& root = hierarchy.nodes()[0];
  for (std::size_t k = 0; k < Hierarchy::width && root.child[k] != hsr::WideTopology::no_child; ++k) {
    const std::vector<std::uint32_t> below = checked_triangles(scene, hierarchy, root, k);
    found.insert(found.end(), below.begin(), below.end());
  }
  std::ranges::sort(found);
  CHECK(found == wanted);
}

hsr::Scene built_in(const std::string& words) {
  const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(words);
  REQUIRE(scene);
  return *scene;
}

}  // namespace

TEST_CASE("raycast: every triangle with an area is in one leaf of the wide hierarchy, within all its boxes") {
  std::vector<hsr::Scene> scenes = {built_in("soup:3000"), built_in("bumpy-sphere:12"), built_in("stadium"),
                                    built_in("degenerate"), hsr::Scene()};
  // An outlier puts all other triangles into one cell of the space-filling curve.
  scenes.push_back(built_in("soup:500"));
  hsr::test::add_triangle(scenes.back(),
                          {glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(3e38F, 1e30F, 0)});
  // And here all centroids are equal.
  scenes.emplace_back();
  for (int k = 1; k <= 100; ++k) {
    const auto size = static_cast<float>(k);
    hsr::test::add_triangle(scenes.back(),
                            {glm::vec3(-size, -size, 0), glm::vec3(size, 0, 0), glm::vec3(0, size, 0)});
  }
  for (const hsr::Scene& scene : scenes) {
    CAPTURE(scene.name);
    check_hierarchy(scene, Hierarchy(scene, hsr::HierarchyBuild::sah, 1));
    check_hierarchy(scene, Hierarchy(scene, hsr::HierarchyBuild::lbvh, 1));
  }
}

TEST_CASE("raycast: a wide hierarchy is the same for any number of threads") {
  const hsr::Scene scene = built_in("soup:9000");
  for (const hsr::HierarchyBuild build : {hsr::HierarchyBuild::sah, hsr::HierarchyBuild::lbvh}) {
    const Hierarchy one(scene, build, 1);
    for (const int threads : {2, 7}) {
      const Hierarchy other(scene, build, threads);
      REQUIRE(one.topology().children == other.topology().children);
      for (std::size_t leaf = 0; leaf < one.topology().leaves.size(); ++leaf) {
        REQUIRE(one.leaves()[leaf].id == other.leaves()[leaf].id);
        REQUIRE(one.leaves()[leaf].corner == other.leaves()[leaf].corner);
      }
    }
  }
}

TEST_CASE("raycast: a wide hierarchy that was refitted holds the triangles where they are now") {
  hsr::Scene scene = built_in("bumpy-sphere:8");
  Hierarchy hierarchy(scene, hsr::HierarchyBuild::sah, 1);
  std::mt19937 random(3);
  for (glm::vec3& position : scene.positions) {
    position = 3.0F * position + glm::vec3(static_cast<float>(random() % 100), -7.0F, 0.1F);
  }
  hierarchy.refit(scene, 2);
  check_hierarchy(scene, hierarchy);
}

TEST_CASE("raycast: triangles have an area in the world exactly when their corners are not on one line") {
  const float u = 0x1p-23F;
  const hsr::Scene scene = hsr::test::scene_of({
      {glm::vec3(0, 0, 0), glm::vec3(1, 1, 1), glm::vec3(3, 3, 3)},
      {glm::vec3(1, 2, 3), glm::vec3(1, 2, 3), glm::vec3(3, 3, 4)},
      {glm::vec3(0, 0, 0), glm::vec3(1, 1, 1), glm::vec3(1 + u, 1, 1)},
      {glm::vec3(1e30F, 0, 0), glm::vec3(0, 1e-30F, 0), glm::vec3(0, 0, 1e-30F)},
  });
  CHECK(hsr::triangles_with_area(scene, 1) == std::vector<std::uint32_t>{2, 3});
}

TEST_CASE("raycast: keys are sorted by their code, and stay in order where codes are equal") {
  std::mt19937_64 random(5);
  std::vector<std::uint64_t> keys(10000);
  for (std::size_t k = 0; k < keys.size(); ++k)
    keys[k] = (random() % 1000 * 1000003 % (1U << 30U)) << 32U | k;
  std::vector<std::uint64_t> wanted = keys;
  std::ranges::stable_sort(wanted, {}, [](std::uint64_t key) { return key >> 32U; });
  for (const int threads : {1, 2, 7}) {
    std::vector<std::uint64_t> sorted = keys;
    hsr::sort_by_code(sorted, threads);
    CHECK(sorted == wanted);
  }
}
