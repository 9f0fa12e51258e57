#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "depthlist/fragment_rows.h"
#include "depthlist/tile_lists.h"

namespace hsr {

/// What is done with the pixels that a triangle covers of a block.
enum class RowUse : std::uint8_t {
  counted,       ///< one is added for each
  kept,          ///< they become a row
  kept_by_depth  ///< with the nearest floats to their depths
};

/// Draws the triangles of a part into the lister's rows; or adds to `counts`, 16 per block; or, if there is a
/// lone pixel (0 ... 15, of a part of a single block), appends its fragments to the lister's.
/// `instruction_set` is a place in the table of lanes/instruction_sets.h.
void draw_rows(std::size_t instruction_set, TileLister& lister, const ListPart& part, RowUse use,
               std::uint32_t* counts, std::optional<int> lone_pixel);

/// Sorts the rows of a block. `opaque` is null, or 1/depth of the surfaces in TilePixels, which take part as
/// the last slot.
void sort_block(std::size_t instruction_set, const FragmentRows& rows, std::size_t block, const float* opaque,
                SortedBlock& sorted);

}  // namespace hsr
