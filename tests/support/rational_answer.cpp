#include "support/rational_answer.h"

#include <algorithm>

namespace hsr::test {

namespace {

mpq_class clip_coordinate(const View& view, int row, const glm::vec3& world) {
  mpq_class sum(view.clip_from_world[3][row]);
  for (int axis = 0; axis < 3; ++axis) {
    sum += mpq_class(view.clip_from_world[axis][row]) * mpq_class(double{world[axis]});
  }
  return sum;
}

}  // namespace

RationalAnswer::RationalAnswer(const View& view)
    : width_(view.width),
      height_(view.height),
      least_inverse_depth_(1 / mpq_class(view.far_depth)),
      greatest_inverse_depth_(1 / mpq_class(view.near_depth)) {
  const int rows[3] = {0, 1, 3};  // x, y, w
  for (const Triangle& triangle : view.scene->triangles) {
    mpq_class corner[3][3];
    for (int k = 0; k < 3; ++k) {
      for (int r = 0; r < 3; ++r) {
        corner[k][r] = clip_coordinate(view, rows[r], view.scene->positions[triangle.corners[k]]);
      }
    }
    ProjectedTriangle projected;
    for (int k = 0; k < 3; ++k) {
      const mpq_class* p = corner[(k + 1) % 3];
      const mpq_class* q = corner[(k + 2) % 3];
      projected.edge[k][0] = p[1] * q[2] - p[2] * q[1];
      projected.edge[k][1] = p[2] * q[0] - p[0] * q[2];
      projected.edge[k][2] = p[0] * q[1] - p[1] * q[0];
    }
    mpq_class det = 0;
    for (int r = 0; r < 3; ++r) det += corner[0][r] * projected.edge[0][r];
    projected.visible = det != 0;
    if (projected.visible) {
      for (auto& edge : projected.edge) {
        for (mpq_class& coefficient : edge) coefficient /= det;
      }
    }
    triangles_.push_back(projected);
  }
}

std::vector<RationalFragment> RationalAnswer::depth_list(int i, int j) const {
  // Divided, as the constructor from two numbers would leave common factors in.
  const mpq_class x = mpq_class(2 * i + 1) / width_ - 1;
  const mpq_class y = 1 - mpq_class(2 * j + 1) / height_;
  std::vector<RationalFragment> list;
  for (std::uint32_t id = 0; id < triangles_.size(); ++id) {
    if (!triangles_[id].visible) continue;
    mpq_class inverse_depth = 0;
    bool inside = true;
    for (const auto& edge : triangles_[id].edge) {
      const mpq_class value = edge[0] * x + edge[1] * y + edge[2];
      inside = inside && value >= 0;
      inverse_depth += value;
    }
    if (inside && inverse_depth >= least_inverse_depth_ && inverse_depth <= greatest_inverse_depth_) {
      list.push_back({id, 1 / inverse_depth});
    }
  }
  std::ranges::stable_sort(
      list, [](const RationalFragment& p, const RationalFragment& q) { return p.depth < q.depth; });
  return list;
}

}  // namespace hsr::test
