#include "abuffer/tile_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "abuffer/pixel_blend.h"
#include "abuffer/sample_rows.h"
#include "depthlist/tile_rows.h"
#include "lanes/instruction_sets.h"
#include "view/shading.h"

namespace hsr {

TileSampler::TileSampler(const SampleRendering& how)
    : how_(how),
      instruction_set_(lanes::dispatch_index(how.instruction_set)),
      chains_per_pixel_((how.pattern.size() + row_lanes - 1) / row_lanes),
      offsets_(),
      rows_(false) {
  for (std::size_t sample = 0; sample < how.pattern.size(); ++sample) {
    // a = 2 raster_x - W and b = H - 2 raster_y: exact, of multiples of 2^-5.
    offsets_.x[sample] = static_cast<float>(how.pattern.a(sample) / 2.0);
    offsets_.y[sample] = static_cast<float>(-how.pattern.b(sample) / 2.0);
  }
}

lanes::Judge& TileSampler::judge() {
  if (!judge_) judge_.emplace(how_.view);
  return *judge_;
}

SampleCounts TileSampler::total() const {
  SampleCounts counts = counts_;
  if (judge_) counts.lanes.lanes_to_exact = judge_->exact_evaluations();
  counts.most_bytes = std::max(counts.most_bytes, fragments_.bytes() + rows_.bytes());
  return counts;
}

std::uint32_t TileSampler::covered_exactly(std::uint32_t id, int i, int j, std::uint32_t asked) {
  const double a = centre_a(how_.view.width, i);
  const double b = centre_b(how_.view.height, j);
  const SampleTriangle triangle = *judge().triangle(id);
  std::uint32_t covered = 0;
  for (std::size_t sample = 0; sample < how_.pattern.size(); ++sample) {
    if ((asked >> sample & 1U) == 0U) continue;
    ++counts_.lanes.lanes_to_double;
    if (judge().predicates().covers(triangle, a + how_.pattern.a(sample), b + how_.pattern.b(sample))) {
      covered |= 1U << sample;
    }
  }
  return covered;
}

float TileSampler::inverse_depth(std::uint32_t id, int i, int j, std::size_t sample, float& error) {
  const BoundedPlane& plane = judge().triangle(id)->inverse_depth;
  const double scale = how_.raster.depth_scale;
  const double value = plane.at(centre_a(how_.view.width, i) + how_.pattern.a(sample),
                                centre_b(how_.view.height, j) + how_.pattern.b(sample)) *
                       scale;
  // Where it is seen it is above 0 and at most 2: what lies outside of that only comes nearer to the truth.
  constexpr double least = 0x1p-120;
  constexpr double greatest = 4.0;
  const double held = std::isfinite(value) ? std::clamp(value, least, greatest) : greatest;
  const double bound = std::isfinite(plane.bound) ? std::min(plane.bound * scale, greatest) : greatest;
  error = std::max(error, static_cast<float>((bound + held * 0x1p-22) * (1.0 + 0x1p-20)));
  return static_cast<float>(held);
}

void TileSampler::render(int left, int top, const PixelBox& box, std::vector<lanes::TileEntry>& entries) {
  // What a transparent surface ties with may count for nothing, and then what lies behind it is seen.
  drops_hidden_ = how_.hidden && std::ranges::all_of(entries, [&](const lanes::TileEntry& entry) {
                    return how_.colors[entry.id].a >= 1.0F;
                  });
  if (drops_hidden_) sort_near_to_far(entries, sorted_entries_);
  hider_.fill(-std::numeric_limits<float>::infinity());
  render_part({left, top, box, entries, {}});
}

void TileSampler::render_part(const SamplePart& part) {
  const bool single_pixel = part.box.first_i == part.box.last_i && part.box.first_j == part.box.last_j;
  fragments_.clear(single_pixel);
  draw_samples(instruction_set_, *this, part);
  if (fragments_.overflowed()) return render_parts_of(part);
  const BlockRange& blocks = part.blocks;
  const int first_i = std::max(part.box.first_i, part.left + blocks.first_x * lanes::block_size);
  const int last_i = std::min(part.box.last_i, part.left + (blocks.last_x + 1) * lanes::block_size - 1);
  const int first_j = std::max(part.box.first_j, part.top + blocks.first_y * lanes::block_size);
  const int last_j = std::min(part.box.last_j, part.top + (blocks.last_y + 1) * lanes::block_size - 1);
  for (int j = first_j; j <= last_j; ++j) {
    for (int i = first_i; i <= last_i; ++i) {
      show_pixel(i, j, SamplePart::pixel_at(i - part.left, j - part.top));
    }
  }
  show_pending();
}

// Too much for once: half of the blocks at a time, or each pixel of a block.
void TileSampler::render_parts_of(const SamplePart& part) {
  if (!part.blocks.single()) {
    for (const bool second : {false, true}) {
      SamplePart half = part;
      half.blocks = part.blocks.half(second);
      render_part(half);
    }
    return;
  }
  const int left = part.left + part.blocks.first_x * lanes::block_size;
  const int top = part.top + part.blocks.first_y * lanes::block_size;
  for (int j = std::max(top, part.box.first_j); j <= std::min(top + lanes::block_size - 1, part.box.last_j);
       ++j) {
    for (int i = std::max(left, part.box.first_i);
         i <= std::min(left + lanes::block_size - 1, part.box.last_i); ++i) {
      SamplePart pixel = part;
      pixel.box = {i, i, j, j};
      render_part(pixel);
    }
  }
}

void TileSampler::show_pixel(int i, int j, std::size_t place) {
  std::size_t count = 0;
  bool opaque = true;
  for (std::uint32_t k = fragments_.first(place); k != SampleFragment::none; k = fragments_[k].next) {
    opaque = opaque && how_.colors[fragments_.surface(fragments_[k]).id].a >= 1.0F;
    ++count;
  }
  if (count == 0) return;
  counts_.fragments += count;
  glm::vec4& color = how_.frame.color[how_.frame.index(i, j)];
  if (how_.one_surface) {
    if (const TileSurface* surface = one_surface(place)) {
      ++counts_.one_surface;
      color = how_.colors[surface->id];
      return;
    }
  }
  if (count > SortedBlock::most_rows) {
    color = blended_by_the_textbook(i, j, place);
    return;
  }
  const std::size_t rows = count * chains_per_pixel_;
  if (pending_rows_ + rows >= FragmentRows::most || (pending_.size() + 1) * chains_per_pixel_ > tile_blocks) {
    show_pending();
  }
  if (pending_.empty()) rows_.clear();
  make_sample_rows(instruction_set_, *this, i, j, place, pending_.size() * chains_per_pixel_);
  pending_.push_back({i, j, opaque});
  pending_rows_ += rows;
}

// The surface that is all that is seen of a pixel, if there surely is one: it fills the pixel, and is opaque
// and before all others, or alone.
const TileSurface* TileSampler::one_surface(std::size_t place) const {
  const auto aside = [&](const TileSurface& surface) {
    // Twice ζ, for the roundings of these sums.
    return 0.5F * (std::abs(surface.x) + std::abs(surface.y)) + 2.0F * surface.error;
  };
  const SampleFragment* nearest = nullptr;
  float least = 0.0F;
  std::size_t count = 0;
  for (std::uint32_t k = fragments_.first(place); k != SampleFragment::none; k = fragments_[k].next) {
    ++count;
    const SampleFragment& fragment = fragments_[k];
    const TileSurface& surface = fragments_.surface(fragment);
    if (!surface.in_lanes) return nullptr;
    if (fragment.mask != how_.pattern.full()) continue;
    const float here = fragment.inverse_depth - aside(surface);
    if (nearest == nullptr || here > least) {
      nearest = &fragment;
      least = here;
    }
  }
  if (nearest == nullptr) return nullptr;
  const TileSurface& surface = fragments_.surface(*nearest);
  if (count == 1) return &surface;
  if (how_.colors[surface.id].a < 1.0F) return nullptr;
  for (std::uint32_t k = fragments_.first(place); k != SampleFragment::none; k = fragments_[k].next) {
    const SampleFragment& fragment = fragments_[k];
    const TileSurface& other = fragments_.surface(fragment);
    if (&fragment != nearest && !(fragment.inverse_depth + aside(other) < least)) return nullptr;
  }
  return &surface;
}

void TileSampler::show_pending() {
  for (std::size_t k = 0; k < pending_.size(); ++k) {
    const Pending& pixel = pending_[k];
    how_.frame.color[how_.frame.index(pixel.i, pixel.j)] = mean_of_samples(k * chains_per_pixel_, pixel);
  }
  pending_.clear();
  pending_rows_ = 0;
}

// Puts the fragments in order at every sample and blends them.
glm::vec4 TileSampler::mean_of_samples(std::size_t chain, const Pending& pixel) {
  const double a = centre_a(how_.view.width, pixel.i);
  const double b = centre_b(how_.view.height, pixel.j);
  const auto id_of = [&](std::uint32_t slot) { return rows_.id(sorted_.row_of[slot]); };
  // In double the sum of so few floats is exact, so the mean of equal colours is that colour.
  glm::dvec4 sum(0.0);
  for (std::size_t first = 0; first < how_.pattern.size(); first += row_lanes) {
    const std::size_t block = chain + first / row_lanes;
    if (rows_.count(block) == 0) continue;
    sort_block(instruction_set_, rows_, block, nullptr, sorted_);
    for (std::size_t lane = 0; lane < std::min(row_lanes, how_.pattern.size() - first); ++lane) {
      if (sorted_.at(0, lane) == SortedBlock::nothing) continue;
      const bool open = (sorted_.open >> lane & 1U) != 0U;
      if (open) {
        counts_.lanes.lanes_to_double += ties_.settle_lane(sorted_, lane, a + how_.pattern.a(first + lane),
                                                           b + how_.pattern.b(first + lane), judge(), id_of);
      }
      if (pixel.all_opaque) {
        sum += glm::dvec4(how_.colors[id_of(sorted_.at(0, lane) & SortedBlock::slot_mask)]);
        continue;
      }
      glm::vec4 color(0.0F);
      for (std::uint32_t rank = 0; rank < sorted_.levels; ++rank) {
        const std::uint32_t entry = sorted_.at(rank, lane);
        if (entry == SortedBlock::nothing) break;
        if (open && (entry & SortedBlock::tied_bit) != 0U) continue;
        const glm::vec4& surface = how_.colors[id_of(entry & SortedBlock::slot_mask)];
        color = over(color, surface);
        if (surface.a >= 1.0F) break;
      }
      sum += glm::dvec4(color);
    }
  }
  return glm::vec4(sum / static_cast<double>(how_.pattern.size()));
}

glm::vec4 TileSampler::blended_by_the_textbook(int i, int j, std::size_t place) {
  struct Found {
    std::uint32_t id;
    std::uint32_t mask;
  };
  std::vector<Found> found;
  for (std::uint32_t k = fragments_.first(place); k != SampleFragment::none; k = fragments_[k].next) {
    found.push_back({fragments_.surface(fragments_[k]).id, fragments_[k].mask});
  }
  std::ranges::sort(found, {}, &Found::id);
  ScreenTriangles triangles;
  std::vector<PixelFragment> list;
  for (const Found& fragment : found) {
    list.push_back({static_cast<std::uint32_t>(triangles.triangles.size()), {fragment.mask, false}});
    triangles.triangles.push_back(*judge().triangle(fragment.id));
  }
  counts_.most_bytes =
      std::max(counts_.most_bytes,
               fragments_.bytes() + rows_.bytes() +
                   found.size() * (sizeof(Found) + sizeof(SampleTriangle) + sizeof(PixelFragment)));
  PixelBlend blend(triangles, how_.pattern, how_.colors, Intersections::by_sample, judge().predicates());
  return blend.color(list, centre_a(how_.view.width, i), centre_b(how_.view.height, j));
}

SampleCounts& SampleCounts::operator+=(const SampleCounts& other) {
  lanes += other.lanes;
  fragments += other.fragments;
  hidden += other.hidden;
  one_surface += other.one_surface;
  most_bytes = std::max(most_bytes, other.most_bytes);
  return *this;
}

}  // namespace hsr
