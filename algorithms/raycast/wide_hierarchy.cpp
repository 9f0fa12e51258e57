#include "raycast/wide_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "parallel.h"
#include "raycast/binned_cuts.h"
#include "raycast/morton_cuts.h"
#include "raycast/world_area.h"

namespace hsr {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// A point among the corners that no far outlier moves: the median of some of them, per axis.
glm::vec3 middle_of_corners(const Scene& scene, const std::vector<std::uint32_t>& ids) {
  constexpr std::size_t most_samples = 511;
  const std::size_t step = ids.size() / most_samples + 1;
  glm::vec3 middle(0.0F);
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    std::vector<float> samples;
    for (std::size_t k = 0; k < ids.size(); k += step) {
      samples.push_back(scene.positions[scene.triangles[ids[k]].corners[0]][axis]);
    }
    const auto median = samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2);
    std::ranges::nth_element(samples, median);
    middle[axis] = *median;
  }
  return middle;
}

// Calls body(index) for 0 ... count - 1 in blocks.
template <class Body>
void for_each_in_parallel(std::size_t count, int threads, Body body) {
  constexpr std::size_t block = 256;
  parallel_for(static_cast<int>((count + block - 1) / block), threads, [&](int index) {
    const std::size_t first = static_cast<std::size_t>(index) * block;
    for (std::size_t k = first; k < std::min(first + block, count); ++k) body(k);
  });
}

}  // namespace

WideHierarchy::WideHierarchy(const Scene& scene, HierarchyBuild build, int threads)
    : order_(triangles_with_area(scene, threads)) {
  if (order_.empty()) return;
  reference_ = middle_of_corners(scene, order_);
  const auto count = static_cast<std::uint32_t>(order_.size());
  if (build == HierarchyBuild::lbvh) {
    MortonCuts cuts(scene, order_, threads);
    topology_ = TopologyBuilder(cuts, threads).build(count);
    order_ = cuts.order();
  } else {
    BinnedCuts cuts(scene, order_, threads);
    topology_ = TopologyBuilder(cuts, threads).build(count);
    order_ = cuts.order();
  }
  nodes_ = std::make_unique_for_overwrite<Node[]>(topology_.children.size());
  leaves_ = std::make_unique_for_overwrite<Leaf[]>(topology_.leaves.size());
  refit(scene, threads);
}

void WideHierarchy::refit(const Scene& scene, int threads) {
  if (empty()) return;
  for_each_in_parallel(topology_.leaves.size(), threads, [&](std::size_t leaf) { fill_leaf(scene, leaf); });
  // Children stand behind their parents.
  for (std::size_t node = topology_.children.size(); node-- > 0;) fill_node(node);
}

void WideHierarchy::fill_leaf(const Scene& scene, std::size_t index) {
  const WideTopology::Leaf& range = topology_.leaves[index];
  Leaf& leaf = leaves_[index];
  leaf.count = range.count;
  std::array<float, 3> magnitude{};
  for (std::uint32_t lane = 0; lane < width; ++lane) {
    const std::uint32_t id = order_[range.first + (lane < range.count ? lane : 0)];
    leaf.id[lane] = id;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec3& position = scene.positions[scene.triangles[id].corners[k]];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const float coordinate = position[static_cast<glm::length_t>(axis)];
        leaf.corner[k][axis][lane] = coordinate;
        magnitude[axis] =
            std::max(magnitude[axis], std::abs(coordinate - reference_[static_cast<glm::length_t>(axis)]));
      }
    }
  }
  // The difference was rounded: by half a unit in the last place at most.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    leaf.magnitude[axis] = std::nextafter(magnitude[axis], infinity);
  }
}

namespace {

// The greatest or least of sixteen numbers, pairwise so that vector instructions can be used.
template <class Pick>
float fold(WideHierarchy::Lanes lanes, Pick pick) {
  for (std::size_t half = WideHierarchy::width / 2; half > 0; half /= 2) {
    for (std::size_t k = 0; k < half; ++k) lanes[k] = pick(lanes[k], lanes[k + half]);
  }
  return lanes[0];
}

float lesser(float a, float b) { return a < b ? a : b; }
float greater(float a, float b) { return a > b ? a : b; }

}  // namespace

void WideHierarchy::fill_node(std::size_t index) {
  Node& node = nodes_[index];
  node.child = topology_.children[index];
  for (std::size_t place = 0; place < width; ++place) {
    const std::uint32_t child = node.child[place];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      float least = infinity;
      float greatest = -infinity;
      if (child != WideTopology::no_child && !WideTopology::is_leaf(child)) {
        // Widened already.
        const Node& below = nodes_[child];
        least = fold(below.border[0][axis], lesser);
        greatest = fold(below.border[1][axis], greater);
      } else if (child != WideTopology::no_child) {
        const Leaf& leaf = leaves_[WideTopology::leaf_index(child)];
        for (const auto& corner : leaf.corner) {
          least = lesser(least, fold(corner[axis], lesser));
          greatest = greater(greatest, fold(corner[axis], greater));
        }
        // Two differences and the product round by half a unit in the last place each, 2^-24 of the
        // magnitude: `widening` is 16 times that, and thrice 2^-24 more are added for them here.
        const float reference = reference_[static_cast<glm::length_t>(axis)];
        const float wider = leaf.magnitude[axis] * (widening + 0x1p-22F) + std::numeric_limits<float>::min();
        if (wider < infinity) {
          least = (least - reference) - wider;
          greatest = (greatest - reference) + wider;
        } else {
          least = -infinity;
          greatest = infinity;
        }
      }
      node.border[0][axis][place] = least;
      node.border[1][axis][place] = greatest;
    }
  }
}

std::uint64_t WideHierarchy::bytes() const {
  return topology_.children.size() * (sizeof(Node) + sizeof(topology_.children[0])) +
         topology_.leaves.size() * (sizeof(Leaf) + sizeof(topology_.leaves[0])) +
         order_.size() * sizeof(order_[0]);
}

}  // namespace hsr
