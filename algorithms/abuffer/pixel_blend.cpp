#include "abuffer/pixel_blend.h"

#include <algorithm>
#include <limits>

#include "view/shading.h"

namespace hsr {

namespace {

bool covers(std::uint32_t mask, std::size_t sample) { return ((mask >> sample) & 1U) != 0; }

// How much of the front one is seen, where the depth ranges of two fragments overlap.
double visible_share(const RankedFragment& front, const RankedFragment& back) {
  const double ranges = (front.greatest_depth - front.least_depth) + (back.greatest_depth - back.least_depth);
  return std::clamp((back.greatest_depth - front.least_depth) / ranges, 0.0, 1.0);
}

}  // namespace

glm::vec4 PixelBlend::color(std::span<const PixelFragment> fragments, double a, double b) {
  const bool all_opaque = std::ranges::all_of(
      fragments, [&](const PixelFragment& fragment) { return surface(fragment.index).a >= 1.0F; });
  if (intersections_ != Intersections::by_sample) {
    rank(fragments, a, b);
  } else if (const SampleTriangle* only = seen_alone(fragments, a, b)) {
    return colors_[only->id];
  }
  // In double the sum of so few floats is exact, so the mean of equal colours is that colour.
  glm::dvec4 sum(0.0);
  for (std::size_t sample = 0; sample < pattern_.size(); ++sample) {
    const double sample_a = a + pattern_.a(sample);
    const double sample_b = b + pattern_.b(sample);
    if (intersections_ != Intersections::by_sample) {
      order_by_rank(sample, sample_a, sample_b);
      sum += glm::dvec4(blended_by_rank());
    } else if (all_opaque) {
      sum += glm::dvec4(nearest_color(fragments, sample, sample_a, sample_b));
    } else {
      order_exactly(fragments, sample, sample_a, sample_b);
      sum += glm::dvec4(composited(exact_, set_up_, colors_));
    }
  }
  return glm::vec4(sum / static_cast<double>(pattern_.size()));
}

// Inside a large face there is one that is opaque, fills the pixel and surely lies before all others.
const SampleTriangle* PixelBlend::seen_alone(std::span<const PixelFragment> fragments, double a,
                                             double b) const {
  const SampleTriangle* nearest = nullptr;
  for (const PixelFragment& fragment : fragments) {
    if (fragment.coverage.mask != pattern_.full() || surface(fragment.index).a < 1.0F) continue;
    const SampleTriangle& triangle = set_up_.triangles[fragment.index];
    if (nearest == nullptr || surely_nearer(triangle, *nearest, a, b)) nearest = &triangle;
  }
  if (nearest == nullptr) return nullptr;
  const bool alone = std::ranges::all_of(fragments, [&](const PixelFragment& fragment) {
    const SampleTriangle& other = set_up_.triangles[fragment.index];
    return &other == nearest || surely_nearer(*nearest, other, a, b);
  });
  return alone ? nearest : nullptr;
}

// The same as sorting, where the first is all that is seen.
glm::vec4 PixelBlend::nearest_color(std::span<const PixelFragment> fragments, std::size_t sample, double a,
                                    double b) {
  const SampleTriangle* nearest = nullptr;
  for (const PixelFragment& fragment : fragments) {
    if (!covers(fragment.coverage.mask, sample)) continue;
    const SampleTriangle& triangle = set_up_.triangles[fragment.index];
    // Fragments are stored by id, so of equal depths the lowest id stays.
    if (nearest == nullptr || predicates_.compare_depth(triangle, *nearest, a, b) < 0) nearest = &triangle;
  }
  return nearest == nullptr ? glm::vec4(0.0F) : colors_[nearest->id];
}

void PixelBlend::order_exactly(std::span<const PixelFragment> fragments, std::size_t sample, double a,
                               double b) {
  exact_.clear();
  for (const PixelFragment& fragment : fragments) {
    if (covers(fragment.coverage.mask, sample)) exact_.push_back({fragment.index, false});
  }
  order_.sort(exact_, a, b);
}

void PixelBlend::rank(std::span<const PixelFragment> fragments, double a, double b) {
  ranked_.clear();
  for (const PixelFragment& fragment : fragments) {
    if (fragment.coverage.mask == 0) continue;
    RankedFragment ranked = {fragment.index, fragment.coverage.mask, std::numeric_limits<double>::infinity(),
                             0.0};
    for (std::size_t sample = 0; sample < pattern_.size(); ++sample) {
      if (!covers(ranked.mask, sample)) continue;
      const double depth = 1.0 / set_up_.triangles[fragment.index].inverse_depth.at(a + pattern_.a(sample),
                                                                                    b + pattern_.b(sample));
      ranked.least_depth = std::min(ranked.least_depth, depth);
      ranked.greatest_depth = std::max(ranked.greatest_depth, depth);
    }
    ranked_.push_back(ranked);
  }
  std::ranges::stable_sort(ranked_, [](const RankedFragment& p, const RankedFragment& q) {
    return p.least_depth < q.least_depth;
  });
}

void PixelBlend::order_by_rank(std::size_t sample, double a, double b) {
  at_sample_.clear();
  for (const RankedFragment& fragment : ranked_) {
    if (!covers(fragment.mask, sample)) continue;
    const SampleTriangle& triangle = set_up_.triangles[fragment.index];
    if (!at_sample_.empty()) {
      RankedFragment& before = at_sample_.back();
      if (predicates_.compare_depth(triangle, set_up_.triangles[before.index], a, b) == 0) {
        before = before.index < fragment.index ? before : fragment;
        continue;
      }
    }
    at_sample_.push_back(fragment);
  }
}

// Front over back where the front one is seen, and the other way round where it is not. Carpenter
// estimates the share of the front one by how far the depth ranges overlap (1984, Intersections).
glm::vec4 PixelBlend::mixed(const RankedFragment& front, const RankedFragment& back) const {
  const auto share = static_cast<float>(visible_share(front, back));
  return share * over(surface(front.index), surface(back.index)) +
         (1.0F - share) * over(surface(back.index), surface(front.index));
}

bool PixelBlend::crosses_next(std::size_t place) const {
  return intersections_ == Intersections::by_depth_range && place + 1 < at_sample_.size() &&
         at_sample_[place + 1].least_depth < at_sample_[place].greatest_depth;
}

glm::vec4 PixelBlend::blended_by_rank() const {
  glm::vec4 color(0.0F);
  for (std::size_t place = 0; place < at_sample_.size(); ++place) {
    const RankedFragment& front = at_sample_[place];
    bool hides = surface(front.index).a >= 1.0F;
    if (crosses_next(place)) {
      const RankedFragment& back = at_sample_[++place];
      hides = hides || surface(back.index).a >= 1.0F;
      color = over(color, mixed(front, back));
    } else {
      color = over(color, surface(front.index));
    }
    if (hides) break;
  }
  return color;
}

// What composited() does, for one sample.
void PixelBlend::add_shares_exactly(Shares& shares) const {
  double through = 1.0;
  for (const OrderedFragment& fragment : exact_) {
    if (fragment.tied) continue;
    shares[fragment.index] += through;
    through *= 1.0 - surface(fragment.index).a;
    if (!(through > 0.0)) return;
  }
}

// What blended_by_rank() does.
void PixelBlend::add_shares_by_rank(Shares& shares) const {
  double through = 1.0;
  for (std::size_t place = 0; place < at_sample_.size() && through > 0.0; ++place) {
    const RankedFragment& front = at_sample_[place];
    const double past_front = 1.0 - surface(front.index).a;
    if (!crosses_next(place)) {
      shares[front.index] += through;
      through *= past_front;
      continue;
    }
    const RankedFragment& back = at_sample_[++place];
    const double past_back = 1.0 - surface(back.index).a;
    const double visible = visible_share(front, back);
    shares[front.index] += through * (visible + (1.0 - visible) * past_back);
    shares[back.index] += through * (visible * past_front + (1.0 - visible));
    through *= past_front * past_back;
  }
}

std::vector<SeenFragment> PixelBlend::seen(std::span<const PixelFragment> fragments, double a, double b) {
  rank(fragments, a, b);
  Shares shares;
  for (std::size_t sample = 0; sample < pattern_.size(); ++sample) {
    const double sample_a = a + pattern_.a(sample);
    const double sample_b = b + pattern_.b(sample);
    if (intersections_ == Intersections::by_sample) {
      order_exactly(fragments, sample, sample_a, sample_b);
      add_shares_exactly(shares);
    } else {
      order_by_rank(sample, sample_a, sample_b);
      add_shares_by_rank(shares);
    }
  }
  std::vector<SeenFragment> result;
  for (const RankedFragment& fragment : ranked_) {
    const auto share = shares.find(fragment.index);
    if (share == shares.end() || !(share->second > 0.0)) continue;
    result.push_back(
        {fragment.index, fragment.least_depth, share->second / static_cast<double>(pattern_.size())});
  }
  return result;
}

}  // namespace hsr
