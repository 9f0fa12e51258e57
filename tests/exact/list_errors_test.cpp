#include "exact/list_errors.h"

#include <doctest/doctest.h>

#include <utility>

#include "support/render.h"
#include "support/small_scenes.h"

TEST_CASE("exact: list errors count what is missing, extra and out of order") {
  hsr::Scene scene;
  for (int k = 0; k < 4; ++k) {
    const auto z = static_cast<float>(k);
    hsr::test::add_triangle(scene, {glm::vec3(-90, -90, z), glm::vec3(90, -90, z), glm::vec3(0, 90, z)});
  }
  hsr::test::add_triangle(scene, {glm::vec3(80, 80, 0), glm::vec3(90, 80, 0), glm::vec3(90, 90, 0)});
  const hsr::View view = hsr::test::front_view(scene, 1, 1, 8.0);
  const hsr::exact::ExactAnswer exact(view, 1);
  const auto errors = [&](std::vector<std::uint32_t> ids) {
    hsr::FragmentLists lists;
    lists.begin = {0, ids.size()};
    for (const std::uint32_t id : ids) lists.fragments.push_back({id, 1.0F, false});
    const hsr::exact::ListErrors found = measure_list_errors(lists, exact, 1, {0, 1}, 1);
    return std::vector<std::uint64_t>{found.missing, found.extra, found.inversions};
  };
  CHECK(errors({3, 2, 1, 0}) == std::vector<std::uint64_t>{0, 0, 0});
  CHECK(errors({}) == std::vector<std::uint64_t>{4, 0, 0});
  CHECK(errors({3, 1, 0}) == std::vector<std::uint64_t>{1, 0, 0});
  CHECK(errors({3, 2, 2, 1, 0}) == std::vector<std::uint64_t>{0, 1, 0});
  CHECK(errors({3, 4, 2, 1, 0}) == std::vector<std::uint64_t>{0, 1, 0});
  CHECK(errors({3, 2, 1, 0, hsr::background_id}) == std::vector<std::uint64_t>{0, 1, 0});
  CHECK(errors({2, 3, 1, 0}) == std::vector<std::uint64_t>{0, 0, 1});
  CHECK(errors({0, 1, 2, 3}) == std::vector<std::uint64_t>{0, 0, 3});
  CHECK(errors({0, 4, 3}) == std::vector<std::uint64_t>{2, 1, 1});
}
