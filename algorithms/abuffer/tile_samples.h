#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "abuffer/sample_fragments.h"
#include "abuffer/sample_pattern.h"
#include "depthlist/exact_ties.h"
#include "depthlist/fragment_rows.h"
#include "depthlist/tile_lists.h"
#include "frame/frame.h"
#include "lanes/judge.h"
#include "lanes/raster_view.h"
#include "lanes/tiles.h"
#include "predicates/pixel_box.h"
#include "view/view.h"

namespace hsr {

/// How the samples of tiles are rendered.
struct SampleRendering {
  const View& view;
  const lanes::RasterView& raster;
  std::string_view instruction_set;
  const std::vector<glm::vec4>& colors;  ///< by id
  const SamplePattern& pattern;
  Frame& frame;
  bool hidden = true;  ///< whether these skips are used
  bool one_surface = true;
};

/// Some blocks of the tile at (left, top), or a single pixel, and the triangles that may cover some of it.
struct SamplePart {
  int left = 0;
  int top = 0;
  PixelBox box;  ///< the pixels that are wanted
  std::span<const lanes::TileEntry> entries;
  BlockRange blocks;

  /// Whether a pixel of the tile is wanted.
  bool holds(int x, int y) const {
    return box.first_i <= left + x && left + x <= box.last_i && box.first_j <= top + y &&
           top + y <= box.last_j;
  }
  /// Its place: block by block, and row by row within a block.
  static std::size_t pixel_at(int x, int y) {
    constexpr int block = lanes::block_size;
    return static_cast<std::size_t>((y / block * lanes::blocks_across + x / block) * block * block +
                                    y % block * block + x % block);
  }
};

/// Where samples lie, in pixels from the pixel's centre, right and down.
struct SampleOffsets {
  alignas(64) float x[SamplePattern::most_samples];
  alignas(64) float y[SamplePattern::most_samples];
};

struct SampleCounts {
  lanes::LaneCounts lanes;
  std::uint64_t fragments = 0;
  std::uint64_t hidden = 0;       ///< fragments left out behind an opaque one that fills the pixel
  std::uint64_t one_surface = 0;  ///< pixels whose samples were not put in order
  std::size_t most_bytes = 0;     ///< held at once by a thread

  SampleCounts& operator+=(const SampleCounts& other);
};

/// Colours the pixels of tiles by their samples, one tile after the other. One per thread.
class TileSampler {
 public:
  explicit TileSampler(const SampleRendering& how);

  /// Colours the pixels in `box` of the tile at (left, top). The entries may be put in another order.
  void render(int left, int top, const PixelBox& box, std::vector<lanes::TileEntry>& entries);

  /// What it took so far.
  SampleCounts total() const;

  // For the code of the instruction sets.
  const SampleRendering& how() const { return how_; }
  lanes::Judge& judge();
  SampleCounts& counts() { return counts_; }
  SampleFragments& fragments() { return fragments_; }
  FragmentRows& rows() { return rows_; }
  const SampleOffsets& offsets() const { return offsets_; }
  /// Of each pixel, 1/depth of an opaque surface that fills it, or less: what is farther is hidden.
  float* hider() { return hider_.data(); }
  /// Whether fragments behind an opaque one are left out.
  bool drops_hidden() const { return drops_hidden_; }
  /// The samples among `asked` of a pixel that a triangle covers.
  std::uint32_t covered_exactly(std::uint32_t id, int i, int j, std::uint32_t asked);
  /// 1/depth of a triangle at a sample in double, and what it may be off by.
  float inverse_depth(std::uint32_t id, int i, int j, std::size_t sample, float& error);

 private:
  // A pixel whose samples stand in rows, in one chain or two.
  struct Pending {
    int i;
    int j;
    bool all_opaque;
  };

  void render_part(const SamplePart& part);
  void render_parts_of(const SamplePart& part);
  void show_pixel(int i, int j, std::size_t place);
  const TileSurface* one_surface(std::size_t place) const;
  void show_pending();
  glm::vec4 mean_of_samples(std::size_t chain, const Pending& pixel);
  glm::vec4 blended_by_the_textbook(int i, int j, std::size_t place);

  SampleRendering how_;
  std::size_t instruction_set_;  // its place in the table
  std::size_t chains_per_pixel_;
  SampleOffsets offsets_;
  std::optional<lanes::Judge> judge_;  // made when the first question comes
  SampleFragments fragments_;
  FragmentRows rows_;
  SortedBlock sorted_;
  ExactTies ties_;
  std::vector<Pending> pending_;
  std::size_t pending_rows_ = 0;
  bool drops_hidden_ = false;
  alignas(64) std::array<float, lanes::tile_pixels> hider_{};
  std::vector<lanes::TileEntry> sorted_entries_;
  SampleCounts counts_;
};

}  // namespace hsr
