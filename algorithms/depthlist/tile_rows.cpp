#include "depthlist/tile_rows.h"

#include "lanes/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "depthlist/tile_rows.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once per instruction set.
#include <hwy/highway.h>

#include "depthlist/block_sort-inl.h"
#include "depthlist/row_drawer-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hsr::HWY_NAMESPACE {

template <RowUse use>
void draw_rows_as(TileLister& lister, const ListPart& part, std::uint32_t* counts,
                  std::optional<int> lone_pixel) {
  RowDrawer<use> drawer(lister, part, counts, lone_pixel);
  lanes::HWY_NAMESPACE::TileTriangles triangles(*lister.how().view.scene, lister.how().raster, part.left,
                                                part.top, drawer);
  for (const lanes::TileEntry& entry : part.drawn()) {
    if (part.blocks.meets(entry)) triangles.add(entry);
  }
  triangles.finish();
}

void draw_rows_in_lanes(TileLister& lister, const ListPart& part, RowUse use, std::uint32_t* counts,
                        std::optional<int> lone_pixel) {
  switch (use) {
    case RowUse::counted:
      return draw_rows_as<RowUse::counted>(lister, part, counts, lone_pixel);
    case RowUse::kept:
      return draw_rows_as<RowUse::kept>(lister, part, counts, lone_pixel);
    case RowUse::kept_by_depth:
      return draw_rows_as<RowUse::kept_by_depth>(lister, part, counts, lone_pixel);
  }
}

void sort_block_in_lanes(const FragmentRows& rows, std::size_t block, const float* opaque,
                         SortedBlock& sorted) {
  // What 1/depth in TilePixels may be off by, as a part of it, and a little for a sum of bounds.
  constexpr auto opaque_share =
      static_cast<float>(lanes::HWY_NAMESPACE::relative_depth_error) * (1.0F + 0x1p-10F);
  BlockSort::sort(rows, block, opaque, opaque_share, sorted);
}

}  // namespace hsr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace hsr {

HWY_EXPORT(draw_rows_in_lanes);
HWY_EXPORT(sort_block_in_lanes);

void draw_rows(std::size_t instruction_set, TileLister& lister, const ListPart& part, RowUse use,
               std::uint32_t* counts, std::optional<int> lone_pixel) {
  HWY_DISPATCH_TABLE(draw_rows_in_lanes)[instruction_set](lister, part, use, counts, lone_pixel);
}

void sort_block(std::size_t instruction_set, const FragmentRows& rows, std::size_t block, const float* opaque,
                SortedBlock& sorted) {
  HWY_DISPATCH_TABLE(sort_block_in_lanes)[instruction_set](rows, block, opaque, sorted);
}

}  // namespace hsr

#endif
