#pragma once

#include <cstddef>

#include "abuffer/tile_samples.h"

namespace hsr {

/// Draws the triangles of a part into the sampler's fragments. `instruction_set` is a place in the table of
/// lanes/instruction_sets.h.
void draw_samples(std::size_t instruction_set, TileSampler& sampler, const SamplePart& part);

/// Makes rows of a pixel's fragments: the chain `chain` of the sampler's rows gets 1/depth at the first 16
/// samples, and, if there are more, the next chain gets the others. `place` is the pixel's in the tile.
void make_sample_rows(std::size_t instruction_set, TileSampler& sampler, int i, int j, std::size_t place,
                      std::size_t chain);

}  // namespace hsr
