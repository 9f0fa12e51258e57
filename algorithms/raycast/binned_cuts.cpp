#include "raycast/binned_cuts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "parallel.h"

namespace hsr {

namespace {

constexpr std::size_t bins = 16;

// Twice the centre of a box, halved first so that it does not overflow.
glm::vec3 centre(const Box& box) { return 0.5F * box.least + 0.5F * box.greatest; }

// Half of a box's area, in double, so that it neither overflows nor underflows.
double half_area(const Box& box) {
  const glm::dvec3 size = glm::dvec3(box.greatest) - glm::dvec3(box.least);
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

struct Bin {
  Box box;
  std::uint32_t count = 0;

  void add(const Bin& other) {
    box = joined(box, other.box);
    count += other.count;
  }
  double cost() const {
    if (count == 0) return 0.0;
    constexpr std::uint32_t width = WideTopology::width;
    const std::uint32_t leaves = (count + width - 1) / width;
    return half_area(box) * leaves;
  }
};

// Which bin a centre falls into, along one axis.
struct Binning {
  glm::length_t axis = 0;
  float least = 0.0F;
  float per_unit = 0.0F;  // bins per unit of length

  std::size_t operator()(const Box& box) const {
    // The centre is within the range that was measured, so the product is not negative, and NaN only
    // where the range is not finite.
    const float place = (centre(box)[axis] - least) * per_unit;
    return place < static_cast<float>(bins - 1) ? static_cast<std::size_t>(std::max(place, 0.0F)) : bins - 1;
  }
};

struct Cut {
  std::size_t last_left = 0;  // the last bin on the left side
  double cost = std::numeric_limits<double>::infinity();
  Bin left;
  Bin right;
};

// Of the cuts between bins the cheapest that leaves something on both sides, if there is one.
Cut cheapest_cut(const std::array<Bin, bins>& bin) {
  std::array<Bin, bins> from_right;
  from_right[bins - 1] = bin[bins - 1];
  for (std::size_t k = bins - 1; k-- > 0;) {
    from_right[k] = from_right[k + 1];
    from_right[k].add(bin[k]);
  }
  Cut best;
  Bin left;
  for (std::size_t k = 0; k + 1 < bins; ++k) {
    left.add(bin[k]);
    const Bin& right = from_right[k + 1];
    if (left.count == 0 || right.count == 0) continue;
    const double cost = left.cost() + right.cost();
    if (cost < best.cost) best = {k, cost, left, right};
  }
  return best;
}

}  // namespace

BinnedCuts::BinnedCuts(const Scene& scene, const std::vector<std::uint32_t>& order, int threads)
    : items_(order.size()) {
  parallel_for_blocks(order.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) items_[k] = {box_of_triangle(scene, order[k]), order[k]};
  });
}

std::pair<TriangleRange, TriangleRange> BinnedCuts::cut(const TriangleRange& range) {
  const auto begin = items_.begin() + range.first;
  const auto end = items_.begin() + range.last;
  Box centres;
  for (auto item = begin; item != end; ++item) {
    const glm::vec3 middle = centre(item->box);
    centres = joined(centres, {middle, middle});
  }
  const glm::vec3 size = centres.greatest - centres.least;
  Binning binning;
  binning.axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
  binning.least = centres.least[binning.axis];
  binning.per_unit = static_cast<float>(bins) / size[binning.axis];

  std::array<Bin, bins> bin;
  for (auto item = begin; item != end; ++item) bin[binning(item->box)].add({item->box, 1});
  const Cut best = cheapest_cut(bin);
  if (best.left.count == 0) {
    // All centres fall into one bin, as they do where they are equal.
    const std::uint32_t middle = range.first + range.count() / 2;
    return {{range.first, middle, range.urgency / 2.0}, {middle, range.last, range.urgency / 2.0}};
  }
  std::partition(begin, end, [&](const Item& item) { return binning(item.box) <= best.last_left; });
  const std::uint32_t middle = range.first + best.left.count;
  return {{range.first, middle, best.left.cost()}, {middle, range.last, best.right.cost()}};
}

std::vector<std::uint32_t> BinnedCuts::order() const {
  std::vector<std::uint32_t> ids(items_.size());
  for (std::size_t k = 0; k < ids.size(); ++k) ids[k] = items_[k].id;
  return ids;
}

}  // namespace hsr
