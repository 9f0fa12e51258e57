#pragma once

#include <glm/vec4.hpp>
#include <string_view>
#include <vector>

#include "frame/frame.h"
#include "lanes/raster_view.h"
#include "zbuffer/zbuffer_fast_tile.h"

namespace hsr {

/// Turns depth_scale / depth of every pixel of a tile into its eye depth: infinity where there is nothing.
void resolve_depths(std::string_view instruction_set, const lanes::RasterView& raster, TilePixels& pixels);

/// Writes the pixels of a tile with resolved depths that lie in `box` to the frame: ids, depths, and colours
/// out of the table `colors` by id unless it is null or the frame has none. (left, top) is the tile's upper
/// left pixel.
void store_tile(std::string_view instruction_set, int left, int top, const PixelBox& box,
                const TilePixels& pixels, const std::vector<glm::vec4>* colors, Frame& frame);

}  // namespace hsr
