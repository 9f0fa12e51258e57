#include "raycast/bvh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/common.hpp>
#include <limits>
#include <numeric>

namespace hsr {

namespace {

// Half the area of the surface, in double so that huge scenes do not overflow.
double half_area(const Box& box) {
  const glm::dvec3 size = glm::dvec3(box.greatest) - glm::dvec3(box.least);
  if (!(size.x >= 0.0)) return 0.0;
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

struct Bin {
  Box box;
  std::uint32_t count = 0;
};

// Builds the tree for a range of triangles at a time, from a stack of nodes still to be cut.
class Builder {
 public:
  Builder(const Scene& scene, std::vector<std::uint32_t>& triangles,
          std::vector<BoundingVolumeHierarchy::Node>& nodes)
      : triangles_(triangles), nodes_(nodes), boxes_(scene.triangles.size()), middles_(boxes_.size()) {
    for (std::uint32_t id = 0; id < boxes_.size(); ++id) {
      boxes_[id] = box_of_triangle(scene, id);
      middles_[id] = (glm::dvec3(boxes_[id].least) + glm::dvec3(boxes_[id].greatest)) / 2.0;
    }
  }

  void build() {
    nodes_.push_back(leaf(0, static_cast<std::uint32_t>(triangles_.size())));
    std::vector<std::uint32_t> open = {0};
    while (!open.empty()) {
      const std::uint32_t node = open.back();
      open.pop_back();
      const std::uint32_t first = nodes_[node].first;
      const std::uint32_t count = nodes_[node].count;
      if (count <= BoundingVolumeHierarchy::leaf_size) continue;
      const std::uint32_t middle = cut(first, count);
      const auto child = static_cast<std::uint32_t>(nodes_.size());
      nodes_.push_back(leaf(first, middle - first));
      nodes_.push_back(leaf(middle, first + count - middle));
      nodes_[node].first = child;
      nodes_[node].count = 0;
      open.push_back(child + 1);
      open.push_back(child);
    }
  }

 private:
  static constexpr int bin_count = 16;

  BoundingVolumeHierarchy::Node leaf(std::uint32_t first, std::uint32_t count) const {
    BoundingVolumeHierarchy::Node node = {{}, first, count};
    for (std::uint32_t place = first; place < first + count; ++place) {
      node.box = joined(node.box, boxes_[triangles_[place]]);
    }
    return node;
  }

  // Reorders the range so that the two children's triangles stand apart; returns where the second
  // child begins. Never leaves a child empty.
  std::uint32_t cut(std::uint32_t first, std::uint32_t count) {
    glm::dvec3 least(std::numeric_limits<double>::infinity());
    glm::dvec3 greatest(-std::numeric_limits<double>::infinity());
    for (std::uint32_t place = first; place < first + count; ++place) {
      least = glm::min(least, middles_[triangles_[place]]);
      greatest = glm::max(greatest, middles_[triangles_[place]]);
    }
    const glm::dvec3 size = greatest - least;
    glm::length_t axis = 0;
    if (size.y > size[axis]) axis = 1;
    if (size.z > size[axis]) axis = 2;
    // All in one place: any cut is as good as any other.
    if (!(size[axis] > 0.0)) return first + count / 2;

    const auto bin_of = [&](std::uint32_t id) {
      const double part = (middles_[id][axis] - least[axis]) / size[axis];
      return std::clamp(static_cast<int>(part * bin_count), 0, bin_count - 1);
    };
    const int first_bin_behind = best_cut(first, count, bin_of);
    const auto begin = triangles_.begin() + first;
    const auto middle = std::stable_partition(
        begin, begin + count, [&](std::uint32_t id) { return bin_of(id) < first_bin_behind; });
    return static_cast<std::uint32_t>(middle - triangles_.begin());
  }

  // The first and the last bin are never empty, so every cut between bins leaves two children.
  template <class BinOf>
  int best_cut(std::uint32_t first, std::uint32_t count, BinOf bin_of) const {
    std::array<Bin, bin_count> bins{};
    for (std::uint32_t place = first; place < first + count; ++place) {
      const std::uint32_t id = triangles_[place];
      Bin& bin = bins[static_cast<std::size_t>(bin_of(id))];
      bin.box = joined(bin.box, boxes_[id]);
      ++bin.count;
    }
    std::array<double, bin_count> cost_before{};  // of everything in the bins before this one
    Bin before;
    for (std::size_t k = 0; k < bin_count; ++k) {
      cost_before[k] = half_area(before.box) * before.count;
      before.box = joined(before.box, bins[k].box);
      before.count += bins[k].count;
    }
    Bin behind;
    int best = 1;
    double least_cost = std::numeric_limits<double>::infinity();
    for (std::size_t k = bin_count - 1; k >= 1; --k) {
      behind.box = joined(behind.box, bins[k].box);
      behind.count += bins[k].count;
      const double cost = cost_before[k] + half_area(behind.box) * behind.count;
      if (cost < least_cost) {
        least_cost = cost;
        best = static_cast<int>(k);
      }
    }
    return best;
  }

  std::vector<std::uint32_t>& triangles_;
  std::vector<BoundingVolumeHierarchy::Node>& nodes_;
  std::vector<Box> boxes_;           // by id
  std::vector<glm::dvec3> middles_;  // by id
};

}  // namespace

BoundingVolumeHierarchy::BoundingVolumeHierarchy(const Scene& scene) {
  if (scene.triangles.empty()) return;
  triangles_.resize(scene.triangles.size());
  std::iota(triangles_.begin(), triangles_.end(), 0U);
  nodes_.reserve(scene.triangles.size());
  Builder(scene, triangles_, nodes_).build();
}

}  // namespace hsr
