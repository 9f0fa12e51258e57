#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lanes/judge.h"
#include "lanes/raster_view.h"
#include "raycast/tile.h"
#include "raycast/tile_beam.h"
#include "raycast/wide_hierarchy.h"

namespace hsr {

/// What is the same for all tiles of a frame.
struct TileTracing {
  TileTracing(const View& view, const WideHierarchy& traced_hierarchy);

  const WideHierarchy& hierarchy;
  lanes::RasterView raster;
  BeamView beams;
  float background = 0.0F;          ///< the inverse depth of the far depth
  float surely_seen = 0.0F;         ///< a computed inverse depth up to this is surely not nearer than near
  float surely_clipped = 0.0F;      ///< a greater one surely is
  std::size_t instruction_set = 0;  ///< lanes::dispatch_index

  // Which skips are used.
  bool skip_missed = true;
  bool skip_behind = true;
  bool skip_pixel_boxes = true;
  bool skip_hidden_blocks = true;
  bool skip_tree = true;
};

/// Work done and left out.
struct BeamCounts {
  lanes::LaneCounts lanes;
  std::uint64_t nodes = 0;          ///< nodes whose children were tested
  std::uint64_t leaves = 0;         ///< leaves whose triangles were set up
  std::uint64_t missed = 0;         ///< boxes that a beam misses
  std::uint64_t behind = 0;         ///< boxes and triangles behind what the whole tile shows
  std::uint64_t pixel_boxes = 0;    ///< triangles of a leaf whose box holds no centre of the tile's pixels
  std::uint64_t hidden_blocks = 0;  ///< blocks that a triangle reaches behind what the block shows

  BeamCounts& operator+=(const BeamCounts& other);
};

/// What one thread needs to trace tiles.
struct TileWorker {
  TileWorker(const View& view, const WideHierarchy& hierarchy);

  struct Open {
    float depth;  ///< scaled as the beam's; the box begins there or behind
    std::uint32_t child;
  };
  lanes::Judge judge;
  std::vector<Open> stack;  ///< as large as it can become
  BeamCounts counts;
};

/// Finds the nearest triangle at every wanted pixel of a tile. Fills `id`, and `inverse_depth` with eye
/// depths, infinite where nothing is shown; both only if the tile is `touched`.
void trace_tile(const TileTracing& tracing, TileWorker& worker, Tile& tile);

}  // namespace hsr
