#include "abuffer/sample_rows.h"

#include <limits>

#include "lanes/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "abuffer/sample_rows.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once per instruction set.
#include <hwy/highway.h>

#include "abuffer/sample_drawer-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hsr::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void draw_samples_in_lanes(TileSampler& sampler, const SamplePart& part) {
  SampleDrawer drawer(sampler, part);
  lanes::HWY_NAMESPACE::TileTriangles triangles(*sampler.how().view.scene, sampler.how().raster, part.left,
                                                part.top, drawer);
  for (const lanes::TileEntry& entry : part.entries) {
    if (part.blocks.meets(entry)) triangles.add(entry);
  }
  triangles.finish();
}

// A surface whose depths floats cannot tell.
void fill_row_in_double(TileSampler& sampler, std::uint32_t id, int i, int j, std::uint32_t mask,
                        std::size_t first_sample, float* row, float& error) {
  for (std::size_t lane = 0; lane < row_lanes; ++lane) {
    const std::size_t sample = first_sample + lane;
    row[lane] = (mask >> sample & 1U) != 0U ? sampler.inverse_depth(id, i, j, sample, error)
                                            : -std::numeric_limits<float>::infinity();
  }
}

void make_rows_in_lanes(TileSampler& sampler, int i, int j, std::size_t place, std::size_t chain) {
  using lanes::HWY_NAMESPACE::block_lanes;
  const lanes::HWY_NAMESPACE::BlockFloats d;
  FragmentRows& rows = sampler.rows();
  const SampleFragments& fragments = sampler.fragments();
  const SampleOffsets& offsets = sampler.offsets();
  const auto nothing = hn::Set(d, -std::numeric_limits<float>::infinity());
  for (std::uint32_t k = fragments.first(place); k != SampleFragment::none; k = fragments[k].next) {
    const SampleFragment& fragment = fragments[k];
    const TileSurface& surface = fragments.surface(fragment);
    for (std::size_t first = 0; first < sampler.how().pattern.size(); first += row_lanes) {
      const std::uint32_t here = fragment.mask >> first & 0xFFFFU;
      if (here == 0) continue;
      float* row = rows.next_inverse_depth();
      float error = surface.error;
      if (!surface.in_lanes) {
        fill_row_in_double(sampler, surface.id, i, j, fragment.mask, first, row, error);
      } else {
        for (std::size_t part = 0; part < row_lanes; part += block_lanes) {
          const auto x = hn::Load(d, offsets.x + first + part);
          const auto y = hn::Load(d, offsets.y + first + part);
          const auto aside = hn::MulAdd(hn::Set(d, surface.x), x, hn::Mul(hn::Set(d, surface.y), y));
          const std::uint32_t bits = here >> part;
          const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits),
                                         static_cast<std::uint8_t>(bits >> 8U)};
          hn::Store(hn::IfThenElse(hn::LoadMaskBits(d, bytes),
                                   hn::Add(hn::Set(d, fragment.inverse_depth), aside), nothing),
                    d, row + part);
        }
      }
      rows.append(chain + first / row_lanes, surface.id, error);
    }
  }
}

}  // namespace hsr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace hsr {

HWY_EXPORT(draw_samples_in_lanes);
HWY_EXPORT(make_rows_in_lanes);

void draw_samples(std::size_t instruction_set, TileSampler& sampler, const SamplePart& part) {
  HWY_DISPATCH_TABLE(draw_samples_in_lanes)[instruction_set](sampler, part);
}

void make_sample_rows(std::size_t instruction_set, TileSampler& sampler, int i, int j, std::size_t place,
                      std::size_t chain) {
  HWY_DISPATCH_TABLE(make_rows_in_lanes)[instruction_set](sampler, i, j, place, chain);
}

}  // namespace hsr

#endif
