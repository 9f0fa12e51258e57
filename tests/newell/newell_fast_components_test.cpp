#include "newell/newell_fast_components.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

namespace {

using hsr::newell_fast::Cells;
using hsr::newell_fast::ComponentSearch;
using hsr::newell_fast::Extent;

using Relation = std::vector<std::vector<bool>>;

/// Whether the one leads to the other by any number of steps.
Relation closure(Relation reached) {
  const std::size_t n = reached.size();
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        if (reached[i][k] && reached[k][j]) reached[i][j] = true;
      }
    }
  }
  return reached;
}

/// Boxes in the picture and in depth, the farthest first.
std::vector<Extent> random_extents(std::mt19937_64& random, std::size_t count) {
  std::uniform_real_distribution<float> place(0.0F, 90.0F);
  std::uniform_real_distribution<float> size(0.0F, 30.0F);
  std::vector<Extent> extents;
  for (std::size_t k = 0; k < count; ++k) {
    const float left = place(random);
    const float top = place(random);
    const float nearest = place(random);
    extents.push_back({left, left + size(random), top, top + size(random), nearest, nearest + size(random)});
  }
  std::ranges::sort(extents, [](const Extent& p, const Extent& q) { return p.farthest > q.farthest; });
  return extents;
}

}  // namespace

TEST_CASE("newell: components come in an order that can be painted, as found by trying all pairs") {
  std::mt19937_64 random(1);
  for (std::size_t round = 0; round < 60; ++round) {
    const std::size_t count = 1 + round;
    const std::vector<Extent> extents = random_extents(random, count);
    // What overlaps in the picture hides in a random direction, or in both; but what lies wholly behind
    // hides nothing.
    Relation hides(count, std::vector<bool>(count, false));
    for (std::size_t p = 0; p < count; ++p) {
      for (std::size_t q = 0; q < count; ++q) {
        if (p == q || extents[p].apart(extents[q]) || extents[q].farthest <= extents[p].nearest) continue;
        hides[p][q] = random() % 3 == 0;
      }
    }
    const Cells cells(extents, 100, 100, [](std::uint32_t, std::array<Extent, 3>&) { return false; });
    ComponentSearch search(extents, cells, round % 2 == 0);
    std::vector<std::uint32_t> order;
    std::vector<std::uint32_t> sizes;
    search.run([&](std::uint32_t p, std::uint32_t q) { return hides[p][q]; },
               [](std::size_t) { return true; }, order, sizes);

    const Relation leads = closure(hides);
    REQUIRE(order.size() == count);
    std::vector<std::size_t> component;
    for (std::size_t k = 0; k < sizes.size(); ++k) component.insert(component.end(), sizes[k], k);
    REQUIRE(component.size() == count);
    for (std::size_t first = 0; first < count; ++first) {
      for (std::size_t later = first + 1; later < count; ++later) {
        const std::uint32_t p = order[first];
        const std::uint32_t q = order[later];
        CAPTURE(round);
        CAPTURE(p);
        CAPTURE(q);
        if (component[first] == component[later]) {
          CHECK((leads[p][q] && leads[q][p]));
        } else {
          CHECK(!hides[p][q]);
        }
      }
    }
  }
}

TEST_CASE("newell: a triangle's cells are those that it meets, and few others") {
  // A needle across the whole picture, from one corner to the other, among many small boxes.
  std::vector<Extent> extents(400, Extent{1.0F, 3.0F, 1.0F, 3.0F, 1.0F, 2.0F});
  extents[7] = {0.0F, 100.0F, 0.0F, 100.0F, 1.0F, 2.0F};
  const std::array<Extent, 3> needle = {
      {{0.0F, 0.0F, 0.0F, 0.0F}, {100.0F, 100.0F, 100.0F, 100.0F}, {0.0F, 0.0F, 1.0F, 1.0F}}};
  const Cells cells(extents, 100, 100, [&](std::uint32_t rank, std::array<Extent, 3>& corners) {
    corners = needle;
    return rank == 7;
  });
  std::size_t side = 0;
  while (side * side < cells.count()) ++side;
  REQUIRE(side * side == cells.count());
  CHECK(cells.cells_of(7).size() <= 3 * side);
  for (std::size_t k = 0; k < side; ++k) {
    CHECK(std::ranges::find(cells.cells_of(7), k * (side + 1)) != cells.cells_of(7).end());
  }
}
