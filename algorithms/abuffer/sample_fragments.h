#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lanes/tiles.h"
#include "scene/scene.h"

namespace hsr {

/// A triangle in a tile, as far as its depth goes: depth_scale / depth is x times the raster x of a sample,
/// counted from its pixel's centre, plus y times its raster y, plus the value at the centre.
struct TileSurface {
  std::uint32_t id = background_id;
  float x = 0.0F;
  float y = 0.0F;
  float error = 0.0F;    ///< bounds what all of it may be off by
  bool in_lanes = true;  ///< false: floats cannot tell its depths
};

/// A triangle in a pixel of a tile.
struct SampleFragment {
  static constexpr std::uint32_t none = ~0U;

  std::uint32_t surface = 0;   ///< its place in SampleFragments
  std::uint32_t mask = 0;      ///< the samples that it covers
  float inverse_depth = 0.0F;  ///< depth_scale / depth at the pixel's centre, wherever the plane goes there
  std::uint32_t next = none;   ///< of the same pixel
};

/// The fragments of a tile, or of some of its blocks, with masks of their samples.
class SampleFragments {
 public:
  /// More are not kept at once (2 MB), unless they are of a single pixel.
  static constexpr std::size_t most = std::size_t{1} << 17U;

  void clear(bool single_pixel) {
    first_.fill(SampleFragment::none);
    surfaces_.clear();
    fragments_.clear();
    overflowed_ = false;
    single_pixel_ = single_pixel;
  }

  std::uint32_t add(const TileSurface& surface) {
    surfaces_.push_back(surface);
    return static_cast<std::uint32_t>(surfaces_.size() - 1);
  }
  /// Adds to the fragments of a pixel: block by block, and row by row within a block.
  void add(std::size_t pixel, std::uint32_t surface, std::uint32_t mask, float inverse_depth) {
    if (fragments_.size() >= most && !single_pixel_) {
      overflowed_ = true;
      return;
    }
    fragments_.push_back({surface, mask, inverse_depth, first_[pixel]});
    first_[pixel] = static_cast<std::uint32_t>(fragments_.size() - 1);
  }

  bool overflowed() const { return overflowed_; }
  /// The fragment of a pixel that came last, or none.
  std::uint32_t first(std::size_t pixel) const { return first_[pixel]; }
  const SampleFragment& operator[](std::uint32_t fragment) const { return fragments_[fragment]; }
  const TileSurface& surface(const SampleFragment& fragment) const { return surfaces_[fragment.surface]; }
  std::size_t bytes() const {
    return fragments_.capacity() * sizeof(SampleFragment) + surfaces_.capacity() * sizeof(TileSurface);
  }

 private:
  std::array<std::uint32_t, lanes::tile_pixels> first_;
  std::vector<TileSurface> surfaces_;
  std::vector<SampleFragment> fragments_;
  bool overflowed_ = false;
  bool single_pixel_ = false;
};

}  // namespace hsr
