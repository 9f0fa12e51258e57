#include "raycast/morton_cuts.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

#include "parallel.h"
#include "raycast/box.h"

namespace hsr {

namespace {

constexpr unsigned bits_per_axis = 10;
constexpr float slices = 1024.0F;

// Moves the ten bits of a number apart: bit k to bit 3 k.
std::uint32_t spread(std::uint32_t bits) {
  bits = (bits | bits << 16U) & 0x030000FFU;
  bits = (bits | bits << 8U) & 0x0300F00FU;
  bits = (bits | bits << 4U) & 0x030C30C3U;
  return (bits | bits << 2U) & 0x09249249U;
}

Box box_of_positions(const Scene& scene, int threads) {
  std::vector<Box> blocks((scene.positions.size() + parallel_block - 1) / parallel_block);
  parallel_for_blocks(scene.positions.size(), threads, [&](std::size_t first, std::size_t last) {
    Box box;
    for (std::size_t k = first; k < last; ++k) box = joined(box, {scene.positions[k], scene.positions[k]});
    blocks[first / parallel_block] = box;
  });
  Box all;
  for (const Box& box : blocks) all = joined(all, box);
  return all;
}

// The code of a triangle's centroid within a box. Corners are divided by three before they are added, so
// that the sum does not overflow; where the box itself does, every code is 0.
class MortonCode {
 public:
  explicit MortonCode(const Box& box) : least_(box.least) {
    const glm::vec3 size = box.greatest - box.least;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      per_unit_[axis] = size[axis] > 0.0F ? slices / size[axis] : 0.0F;
    }
  }

  std::uint32_t operator()(const Scene& scene, std::uint32_t id) const {
    const std::array<std::uint32_t, 3>& corners = scene.triangles[id].corners;
    constexpr float third = 1.0F / 3.0F;
    const glm::vec3 centroid = third * scene.positions[corners[0]] + third * scene.positions[corners[1]] +
                               third * scene.positions[corners[2]];
    std::uint32_t code = 0;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      const float place = (centroid[axis] - least_[axis]) * per_unit_[axis];
      const float clamped = place > 0.0F ? std::min(place, slices - 1.0F) : 0.0F;  // 0 for NaN
      code |= spread(static_cast<std::uint32_t>(clamped)) << static_cast<unsigned>(axis);
    }
    return code;
  }

 private:
  glm::vec3 least_;
  glm::vec3 per_unit_{0.0F};
};

constexpr unsigned digit_bits = 10;
constexpr std::size_t digits = 1U << digit_bits;
using Histogram = std::array<std::uint32_t, digits>;

std::size_t digit_of(std::uint64_t key, unsigned shift) { return (key >> shift) & (digits - 1); }

// One pass of a radix sort, from `from` to `to`. Each block of keys counts its digits, then all blocks are
// given their places, and each moves its keys in order.
void sort_by_digit(const std::vector<std::uint64_t>& from, std::vector<std::uint64_t>& to, unsigned shift,
                   int threads) {
  const auto blocks = static_cast<std::size_t>(threads);
  const std::size_t size = (from.size() + blocks - 1) / blocks;
  std::vector<Histogram> place(blocks);
  const auto for_each_key = [&](int block, auto body) {
    const std::size_t first = static_cast<std::size_t>(block) * size;
    for (std::size_t k = first; k < std::min(first + size, from.size()); ++k) body(from[k]);
  };
  parallel_for(threads, threads, [&](int block) {
    Histogram& counts = place[static_cast<std::size_t>(block)];
    counts.fill(0);
    for_each_key(block, [&](std::uint64_t key) { ++counts[digit_of(key, shift)]; });
  });
  std::uint32_t next = 0;
  for (std::size_t digit = 0; digit < digits; ++digit) {
    for (Histogram& counts : place) {
      const std::uint32_t count = counts[digit];
      counts[digit] = next;
      next += count;
    }
  }
  parallel_for(threads, threads, [&](int block) {
    Histogram& places = place[static_cast<std::size_t>(block)];
    for_each_key(block, [&](std::uint64_t key) { to[places[digit_of(key, shift)]++] = key; });
  });
}

}  // namespace

void sort_by_code(std::vector<std::uint64_t>& keys, int threads) {
  std::vector<std::uint64_t> other(keys.size());
  for (unsigned shift = 32; shift < 32 + 3 * bits_per_axis; shift += digit_bits) {
    sort_by_digit(keys, other, shift, threads);
    keys.swap(other);
  }
}

MortonCuts::MortonCuts(const Scene& scene, const std::vector<std::uint32_t>& ids, int threads)
    : keys_(ids.size()) {
  const MortonCode code_of(box_of_positions(scene, threads));
  parallel_for_blocks(ids.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      keys_[k] = std::uint64_t{code_of(scene, ids[k])} << 32U | ids[k];
    }
  });
  sort_by_code(keys_, threads);
  constexpr auto width = static_cast<std::uint32_t>(WideTopology::width);
  for (std::uint32_t k = width; k < keys_.size(); ++k) {
    if (code(k - width) != code(k)) continue;
    bins_.emplace(scene, order(), threads);
    break;
  }
}

std::pair<TriangleRange, TriangleRange> MortonCuts::cut(const TriangleRange& range) {
  const std::uint32_t difference = code(range.first) ^ code(range.last - 1);
  std::pair<TriangleRange, TriangleRange> parts;
  if (difference == 0) {
    parts = bins_->cut(range);
  } else {
    // Codes of a range agree above their first difference, so those that have that bit stand behind.
    const std::uint64_t bit = std::uint64_t{std::bit_floor(difference)} << 32U;
    const auto begin = keys_.begin() + range.first;
    const auto middle = std::partition_point(begin, keys_.begin() + range.last,
                                             [bit](std::uint64_t key) { return (key & bit) == 0; });
    const auto place = static_cast<std::uint32_t>(middle - keys_.begin());
    parts = {{range.first, place, 0.0}, {place, range.last, 0.0}};
  }
  parts.first.urgency = parts.first.count();
  parts.second.urgency = parts.second.count();
  return parts;
}

std::vector<std::uint32_t> MortonCuts::order() const {
  if (bins_) return bins_->order();
  std::vector<std::uint32_t> ids(keys_.size());
  for (std::size_t k = 0; k < ids.size(); ++k) ids[k] = static_cast<std::uint32_t>(keys_[k]);
  return ids;
}

}  // namespace hsr
