#include "zbuffer/zbuffer_fast_store.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "lanes/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "zbuffer/zbuffer_fast_store.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once per instruction set.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hsr::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// depth_scale / inverse, within 2^-21. One step of Newton's squares the error of an approximate reciprocal,
// which on x86 is at most 1.5 * 2^-12, to less than 2^-22, and three operations round. It takes a third of
// the time of a division, of which there would be one for each pixel. Elsewhere approximations may be
// coarser.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V quotient(D d, V scale, V inverse) {
#if HWY_ARCH_X86
  const V guess = hn::ApproximateReciprocal(inverse);
  return hn::Mul(scale, hn::Mul(guess, hn::NegMulAdd(inverse, guess, hn::Set(d, 2.0F))));
#else
  return hn::Div(scale, inverse);
#endif
}

// Turns every 1/depth of the tile into a depth, in place.
void depths_of_tile(float depth_scale, TilePixels& pixels) {
  const hn::CappedTag<float, 16> d;
  const auto infinity = hn::Set(d, std::numeric_limits<float>::infinity());
  const auto scale = hn::Set(d, depth_scale);
  for (std::size_t k = 0; k < lanes::tile_pixels; k += hn::MaxLanes(d)) {
    const auto inverse = hn::Load(d, pixels.inverse_depth + k);
    // Nothing there: -infinity.
    const auto seen = hn::Gt(inverse, hn::Zero(d));
    hn::Store(hn::IfThenElse(seen, quotient(d, scale, inverse), infinity), d, pixels.inverse_depth + k);
  }
}

// Writes a row of pixels of some consecutive blocks. Whole cache lines go past the caches, as nobody reads
// them soon; those that the neighbouring tile writes to as well must not.
template <class T>
HWY_INLINE void store_row(const T* blocks, int count, T* row) {
  constexpr int block = lanes::block_size;
  constexpr std::uintptr_t line = 64;
  constexpr int blocks_per_line = static_cast<int>(line / (block * sizeof(T)));
  const hn::CappedTag<T, block> d;
  static_assert(hn::MaxLanes(d) == block, "needs vectors of 128 bits");
  const auto values = [&](int k) HWY_ATTR { return hn::Load(d, blocks + k * block * block); };
  const auto place = reinterpret_cast<std::uintptr_t>(row);
  int k = 0;
  if (place % (block * sizeof(T)) == 0) {
    const auto before = static_cast<int>((line - place % line) % line / (block * sizeof(T)));
    for (; k < std::min(before, count); ++k) hn::StoreU(values(k), d, row + k * block);
    for (; k + blocks_per_line <= count; k += blocks_per_line) {
      for (int n = k; n < k + blocks_per_line; ++n) hn::Stream(values(n), d, row + n * block);
    }
  }
  for (; k < count; ++k) hn::StoreU(values(k), d, row + k * block);
}

void store_pixels(int left, int top, const PixelBox& box, const TilePixels& pixels, Frame& frame) {
  constexpr int block = lanes::block_size;
  for (int j = box.first_j; j <= box.last_j; ++j) {
    const int y = j - top;
    const std::size_t row =
        static_cast<std::size_t>(y / block * lanes::blocks_across * block * block + y % block * block);
    float* depth = frame.depth.data() + frame.index(box.first_i, j);
    std::uint32_t* id = frame.id.data() + frame.index(box.first_i, j);
    int i = box.first_i;
    if (box.first_i == left) {
      const int blocks = (box.last_i + 1 - left) / block;
      store_row(pixels.inverse_depth + row, blocks, depth);
      store_row(pixels.id + row, blocks, id);
      i += blocks * block;
    }
    for (; i <= box.last_i; ++i) {
      const int x = i - left;
      const std::size_t pixel = row + static_cast<std::size_t>(x / block * block * block + x % block);
      frame.depth[frame.index(i, j)] = pixels.inverse_depth[pixel];
      frame.id[frame.index(i, j)] = pixels.id[pixel];
    }
  }
  hwy::FlushStream();
}

}  // namespace hsr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace hsr {

HWY_EXPORT(depths_of_tile);
HWY_EXPORT(store_pixels);

void resolve_depths(std::string_view instruction_set, const lanes::RasterView& raster, TilePixels& pixels) {
  HWY_DISPATCH_TABLE(depths_of_tile)
  [lanes::dispatch_index(instruction_set)](static_cast<float>(raster.depth_scale), pixels);
}

void store_tile(std::string_view instruction_set, int left, int top, const PixelBox& box,
                const TilePixels& pixels, const std::vector<glm::vec4>* colors, Frame& frame) {
  HWY_DISPATCH_TABLE(store_pixels)[lanes::dispatch_index(instruction_set)](left, top, box, pixels, frame);
  if (colors == nullptr || frame.color.empty()) return;
  for (int j = box.first_j; j <= box.last_j; ++j) {
    for (int i = box.first_i; i <= box.last_i; ++i) {
      const std::size_t pixel = frame.index(i, j);
      const std::uint32_t id = frame.id[pixel];
      frame.color[pixel] = id == background_id ? glm::vec4(0.0F) : (*colors)[id];
    }
  }
}

}  // namespace hsr

#endif
