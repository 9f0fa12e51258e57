#include "scene/triangulate.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>
#include <map>
#include <random>
#include <utility>
#include <vector>

using hsr::CornerTriple;
using Outline = std::vector<glm::vec3>;

namespace {

/// Twice the area of a triangle of whole-numbered corners in the plane z = 0, with sign.
double signed_area(const Outline& outline, const CornerTriple& t) {
  const glm::dvec3 a(outline[t[0]]);
  const glm::dvec3 b(outline[t[1]]);
  const glm::dvec3 c(outline[t[2]]);
  return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
}

struct Result {
  std::vector<CornerTriple> triangles;
  bool fills = false;
  double area = 0;      // of all triangles, each counted as it winds
  double covering = 0;  // of all triangles, each counted as positive
};

Result cut(const Outline& outline) {
  Result result;
  result.fills = hsr::triangulate(outline, result.triangles);
  for (const CornerTriple& triple : result.triangles) {
    result.area += signed_area(outline, triple);
    result.covering += std::abs(signed_area(outline, triple));
  }
  return result;
}

Outline flat(const std::vector<std::pair<int, int>>& points) {
  Outline outline;
  for (const auto& [x, y] : points) {
    outline.emplace_back(static_cast<float>(x), static_cast<float>(y), 0.0F);
  }
  return outline;
}

/// Checks that an outline of the given signed area is filled without overlap, from every first corner
/// and also wound the other way.
void check_filled(std::vector<std::pair<int, int>> points, double area) {
  for (std::size_t turn = 0; turn < points.size(); ++turn) {
    std::rotate(points.begin(), points.begin() + 1, points.end());
    std::vector<std::pair<int, int>> backwards(points.rbegin(), points.rend());
    CAPTURE(turn);
    for (const auto& [outline, want] : {std::pair(flat(points), area), std::pair(flat(backwards), -area)}) {
      const Result result = cut(outline);
      CHECK(result.fills);
      CHECK(result.triangles.size() == points.size() - 2);
      CHECK(result.area == want);
      CHECK(result.covering == std::abs(want));
    }
  }
}

using Cell = std::pair<int, int>;

/// The outline of squares that hang together by a random tree of common sides: where two squares
/// touch otherwise it runs back and forth along their side, so that it touches itself everywhere.
class CellTree {
 public:
  CellTree(std::mt19937& random, std::size_t cells) {
    std::vector<Cell> order{{0, 0}};
    children_[{0, 0}] = {};
    while (children_.size() < cells) {
      const Cell parent = order[random() % order.size()];
      const auto side = static_cast<std::size_t>(random() % 4);
      const Cell child(parent.first + step_x[side], parent.second + step_y[side]);
      if (children_.try_emplace(child).second) {
        children_[parent][side] = true;
        order.push_back(child);
      }
    }
    walk({0, 0}, 0, true);
  }

  const std::vector<std::pair<int, int>>& outline() const { return outline_; }

 private:
  static constexpr std::array<int, 4> step_x{0, 1, 0, -1};
  static constexpr std::array<int, 4> step_y{-1, 0, 1, 0};
  static constexpr std::array<int, 4> corner_x{0, 1, 1, 0};
  static constexpr std::array<int, 4> corner_y{0, 0, 1, 1};

  void walk(const Cell& cell, std::size_t from, bool is_root) {
    for (std::size_t k = is_root ? 0 : 1; k < 4; ++k) {
      const std::size_t side = (from + k) % 4;
      if (children_[cell][side]) {
        walk({cell.first + step_x[side], cell.second + step_y[side]}, (side + 2) % 4, false);
      }
      const std::size_t corner = (side + 1) % 4;
      outline_.emplace_back(cell.first + corner_x[corner], cell.second + corner_y[corner]);
    }
  }

  std::map<Cell, std::array<bool, 4>> children_;
  std::vector<std::pair<int, int>> outline_;
};

}  // namespace

TEST_CASE("scene: a convex polygon becomes the fan from its first corner, wound as it is") {
  const std::vector<CornerTriple> fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  CHECK(cut(flat({{0, 0}, {4, 0}, {6, 3}, {3, 6}, {0, 4}})).triangles == fan);
  CHECK(cut(flat({{0, 4}, {3, 6}, {6, 3}, {4, 0}, {0, 0}})).triangles == fan);
  CHECK(cut(flat({{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}})).triangles == fan);  // a corner on a side
}

TEST_CASE("scene: concave outlines are filled from whichever corner they begin") {
  check_filled({{0, 0}, {4, 0}, {1, 1}, {0, 4}}, 4);                                   // arrowhead
  check_filled({{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}, 20);  // U
  check_filled({{0, 0}, {3, 0}, {6, 0}, {6, 6}, {3, 6}, {3, 3}, {3, 2}, {0, 2}}, 24);  // L, straight corners
}

TEST_CASE("scene: a hole on a bridge stays open") {
  check_filled({{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {3, 3}, {3, 6}, {6, 6}, {6, 3}, {3, 3}}, 72);
  // Two holes on bridges from the same corner.
  check_filled({{0, 0},
                {9, 0},
                {9, 9},
                {0, 9},
                {0, 0},
                {1, 4},
                {1, 6},
                {3, 6},
                {1, 4},
                {0, 0},
                {4, 1},
                {6, 3},
                {6, 1},
                {4, 1}},
               77);
}

TEST_CASE("scene: outlines that touch themselves are filled") {
  check_filled({{7, 18}, {7, 15}, {5, 15}, {7, 13}, {7, 15}, {17, 17}}, 17);          // hourglass
  check_filled({{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}, 8);                  // two tips that meet
  check_filled({{0, 0}, {4, 0}, {4, 4}, {8, 8}, {4, 4}, {0, 4}}, 16);                 // a spike outwards
  check_filled({{0, 0}, {4, 0}, {4, 4}, {2, 2}, {4, 4}, {0, 4}}, 16);                 // a spike inwards
  check_filled({{1, 0}, {1, 1}, {0, 1}, {0, 0}, {0, 1}, {0, 0}, {0, 1}, {0, 0}}, 1);  // back and forth
  // Two squares joined by a bridge without width that has a bend.
  check_filled(
      {{0, 0}, {2, 0}, {2, 2}, {5, 2}, {5, 5}, {7, 5}, {7, 7}, {5, 7}, {5, 5}, {5, 2}, {2, 2}, {0, 2}}, 8);
}

TEST_CASE("scene: outlines of random trees of squares are filled, sheared and far away, too") {
  std::mt19937 random(2);
  for (int round = 0; round < 300; ++round) {
    CAPTURE(round);
    const std::size_t cells = 1 + random() % 25;
    std::vector<std::pair<int, int>> points = CellTree(random, cells).outline();
    const int shear = static_cast<int>(random() % 5) - 2;
    const int offset = static_cast<int>(random() % 3) * 1000000;
    for (auto& [x, y] : points) {
      x = 3 * x + shear * y + offset;
      y = y - offset;
    }
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(random() % points.size()),
                points.end());
    const Result result = cut(flat(points));
    REQUIRE(result.fills);
    REQUIRE(result.triangles.size() == points.size() - 2);
    REQUIRE(result.area == 3.0 * static_cast<double>(cells));
    REQUIRE(result.covering == result.area);
  }
}

TEST_CASE("scene: a polygon is cut in its own plane, whichever way that faces") {
  const Outline arrowhead{{5, 0, 0}, {5, 4, 0}, {5, 1, 1}, {5, 0, 4}};  // in the plane x = 5
  std::vector<CornerTriple> triangles;
  CHECK(hsr::triangulate(arrowhead, triangles));
  for (const CornerTriple& t : triangles) {
    const glm::vec3 u = arrowhead[t[1]] - arrowhead[t[0]];
    const glm::vec3 v = arrowhead[t[2]] - arrowhead[t[0]];
    CHECK(u.y * v.z - u.z * v.y > 0.0F);
  }
}

TEST_CASE("scene: the diagonal of a concave quadrilateral far from the origin is the inner one") {
  const float x = 14678.0F;
  const float y = 9605.0F;
  const Outline outline{{x, y, 0}, {x + 2, y, 0}, {x + 0.5F, y + 0.5F, 0}, {x, y + 2, 0}};
  Outline from_next(outline.begin() + 1, outline.end());
  from_next.push_back(outline.front());
  CHECK(cut(outline).covering == 1.0);
  CHECK(cut(from_next).covering == 1.0);
}

TEST_CASE("scene: outlines without area or with crossings still give n - 2 triangles") {
  const Result line = cut(flat({{0, 0}, {1, 1}, {2, 2}, {3, 3}, {1, 1}}));
  CHECK(line.fills);
  CHECK(line.triangles.size() == 3);
  CHECK(cut(Outline(7, glm::vec3(1.0F))).triangles.size() == 5);
  const Result bow = cut(flat({{0, 0}, {2, 2}, {2, 0}, {0, 2}}));
  CHECK_FALSE(bow.fills);
  CHECK(bow.triangles.size() == 2);
  const Result star = cut(flat({{0, 10}, {6, -8}, {-10, 3}, {10, 3}, {-6, -8}}));
  CHECK_FALSE(star.fills);
  CHECK(star.triangles.size() == 3);
  std::mt19937 random(4);
  for (int round = 0; round < 200; ++round) {
    std::vector<std::pair<int, int>> points(3 + random() % 30);
    for (auto& point : points) {
      point = {static_cast<int>(random() % 8), static_cast<int>(random() % 8)};
    }
    REQUIRE(cut(flat(points)).triangles.size() == points.size() - 2);
  }
}

TEST_CASE("scene: an outline of ten thousand corners is cut in well under a second") {
  std::vector<std::pair<int, int>> comb;
  for (int i = 0; i < 5000; ++i) {
    comb.emplace_back(2 * i, 0);
    comb.emplace_back(2 * i + 1, 1000);
  }
  comb.emplace_back(10000, -1);
  comb.emplace_back(-1, -1);
  const Result result = cut(flat(comb));
  CHECK(result.fills);
  CHECK(result.covering == std::abs(result.area));
}

TEST_CASE("scene: triangles without area are told exactly") {
  CHECK(hsr::has_no_area({0, 0, 0}, {1, 2, 3}, {2, 4, 6}));
  CHECK(hsr::has_no_area({1, 2, 3}, {1, 2, 3}, {5, 5, 5}));
  CHECK(hsr::has_no_area({1e30F, 0, 0}, {-1e30F, 0, 0}, {1e-30F, 0, 0}));
  CHECK_FALSE(hsr::has_no_area({0, 0, 0}, {1, 2, 3}, {2, 4, std::nextafter(6.0F, 7.0F)}));
  CHECK_FALSE(hsr::has_no_area({1e30F, 0, 0}, {-1e30F, 0, 0}, {0, 0, 1e-45F}));
}
