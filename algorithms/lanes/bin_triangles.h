#pragma once

#include <cstdint>
#include <vector>

#include "algorithm.h"
#include "lanes/raster_view.h"
#include "lanes/screen_vertices.h"
#include "lanes/tiles.h"
#include "view/view.h"

namespace hsr::lanes {

/// The triangles of a view by tiles. Keeps its memory, and nothing else, from one view to the next.
class BinnedView {
 public:
  /// Transforms every vertex and puts every triangle into the tiles that it may cover, with the skips
  /// off-screen and between-centres (skips.h) as the options allow. With a window, tiles outside it stay
  /// empty. Adds to the report what was left out and the memory. With a `sample_reach` above 0 (in pixels,
  /// below 1/2), a triangle may cover a pixel at samples that far to the right, left, top and bottom of its
  /// centre.
  void bin(const View& view, const RasterView& raster, const RenderOptions& options, RenderReport& report,
           double sample_reach = 0.0);

  const TileGrid& grid() const { return grid_; }
  /// How many entries a tile has.
  std::size_t count(int tile) const;
  /// Calls visit(entry) for every entry of a tile, by increasing id.
  template <class Visit>
  void for_each(int tile, Visit visit) const {
    for (const TileBins& part : parts_) part.for_each(tile, visit);
  }

 private:
  TileGrid grid_;
  std::vector<ScreenVertex> vertices_;
  std::vector<TileBins> parts_;  // of consecutive triangles each
};

}  // namespace hsr::lanes
