#include "predicates/sample_predicates.h"

#include <bit>
#include <cmath>
#include <limits>

namespace hsr {

namespace {

// Powers of two: the triangles and corners that were asked about last.
constexpr std::size_t fixed_entries = 64;
constexpr std::size_t whole_entries = 256;

bool whole(double number) { return number == std::floor(number); }

int sign_at(const Homogeneous<Dyadic>& plane, double a, double b) { return at_sample(plane, a, b).sign(); }

}  // namespace

SamplePredicates::SamplePredicates(const Projection& projection, const Scene& scene)
    : projection_(projection),
      sure_inverse_near_((Bounded(1.0) / Bounded(projection.near_depth)).lower()),
      sure_inverse_far_((Bounded(1.0) / Bounded(projection.far_depth)).upper()),
      triangles_(projection, scene),
      scene_(scene),
      fixed_projection_(fixed_projection(projection)),
      fixed_triangles_(fixed_projection_ ? fixed_entries : 0),
      whole_corners_(fixed_projection_ ? whole_entries : 0) {}

std::optional<SampleTriangle> SamplePredicates::set_up(std::uint32_t id,
                                                       const std::array<Homogeneous<Bounded>, 3>& corner) {
  const HomogeneousTriangle<Bounded> triangle = homogeneous_triangle(projection_, corner);
  int orientation = 0;
  if (triangle.det.surely_positive()) orientation = 1;
  if (triangle.det.surely_negative()) orientation = -1;
  if (orientation == 0) {
    ++exact_evaluations_;
    orientation = triangles_.one(id).orientation;
    if (orientation == 0) return std::nullopt;
  }

  SampleTriangle result;
  result.id = id;
  result.front = orientation > 0;
  const Bounded turned(static_cast<double>(orientation));
  for (std::size_t k = 0; k < 3; ++k) {
    const Homogeneous<Bounded> edge = {triangle.edge[k][0] * turned, triangle.edge[k][1] * turned,
                                       triangle.edge[k][2] * turned};
    result.edge[k] = bounded_plane(edge, projection_.width, projection_.height);
  }
  const Homogeneous<Bounded> inverse_depth = {triangle.sum[0] / triangle.det, triangle.sum[1] / triangle.det,
                                              triangle.sum[2] / triangle.det};
  result.inverse_depth = bounded_plane(inverse_depth, projection_.width, projection_.height);

  result.within_depth_range = true;
  for (const Homogeneous<Bounded>& point : corner) {
    if (!(point[2].lower() > projection_.near_depth && point[2].upper() < projection_.far_depth)) {
      result.within_depth_range = false;
    }
  }
  return result;
}

const std::optional<FixedTriangle>& SamplePredicates::fixed_triangle(std::uint32_t id) {
  FixedEntry& entry = fixed_triangles_[id % fixed_entries];
  if (entry.id != id) entry = {id, FixedTriangle::make(*fixed_projection_, scene_, id)};
  return entry.triangle;
}

const WholeCorner& SamplePredicates::corner(std::uint32_t id, std::size_t k) {
  const std::uint32_t vertex = scene_.triangles[id].corners[k];
  WholeEntry& entry = whole_corners_[vertex % whole_entries];
  if (entry.vertex != vertex) {
    entry = {vertex, whole_corner(projection_, *fixed_projection_, scene_.positions[vertex])};
  }
  return entry.corner;
}

// Nothing where the numbers do not fit.
std::optional<bool> SamplePredicates::covers_in_fixed_width(const SampleTriangle& filtered, double a,
                                                            double b) {
  if (!fixed_projection_ || !filtered.within_depth_range || !whole(a) || !whole(b)) return std::nullopt;
  for (std::size_t k = 0; k < 3; ++k) {
    if (filtered.edge[k].at(a, b) > filtered.edge[k].bound) continue;
    const WholeCorner from = corner(filtered.id, (k + 1) % 3);  // a copy: both may have one place
    std::optional<int> sign = edge_sign(from, corner(filtered.id, (k + 2) % 3), static_cast<std::int64_t>(a),
                                        static_cast<std::int64_t>(b));
    if (!sign) {
      const std::optional<FixedTriangle>& fixed = fixed_triangle(filtered.id);
      if (!fixed) return std::nullopt;
      sign = fixed->edge_sign(k, a, b);
    }
    if (*sign * (filtered.front ? 1 : -1) < 0) return false;
  }
  return true;
}

bool SamplePredicates::exactly_covers(const SampleTriangle& filtered, double a, double b) {
  ++exact_evaluations_;
  if (const std::optional<bool> known = covers_in_fixed_width(filtered, a, b)) return *known;
  const ExactTriangle& triangle = triangles_.one(filtered.id);
  if (triangle.orientation == 0) return false;
  for (const Homogeneous<Dyadic>& edge : triangle.oriented.edge) {
    if (sign_at(edge, a, b) < 0) return false;
  }
  // 1/far <= sum / det <= 1/near, multiplied by det > 0 and by near or far > 0.
  const Dyadic sum = at_sample(triangle.oriented.sum, a, b);
  const Dyadic& det = triangle.oriented.det;
  return (sum * Dyadic(projection_.far_depth) - det).sign() >= 0 &&
         (sum * Dyadic(projection_.near_depth) - det).sign() <= 0;
}

int SamplePredicates::exactly_compare_depth(std::uint32_t p, std::uint32_t q, double a, double b) {
  if (p == q) return 0;
  ++exact_evaluations_;
  if (triangles_.same_plane(p, q)) return 0;
  const auto [first, second] = triangles_.pair(p, q);
  const Dyadic inverse_p = at_sample(first.oriented.sum, a, b) * second.oriented.det;
  const Dyadic inverse_q = at_sample(second.oriented.sum, a, b) * first.oriented.det;
  return (inverse_q - inverse_p).sign();
}

mpq_class SamplePredicates::exact_inverse_depth(const SampleTriangle& triangle, double a, double b) {
  ++exact_evaluations_;
  const ExactTriangle& exact = triangles_.one(triangle.id);
  return quotient(at_sample(exact.oriented.sum, a, b), exact.oriented.det);
}

float SamplePredicates::nearest_float_depth(const SampleTriangle& triangle, double a, double b) {
  const Bounded depth = Bounded(1.0) / Bounded(triangle.inverse_depth.at(a, b), triangle.inverse_depth.bound);
  constexpr double greatest = std::numeric_limits<float>::max();
  if (depth.upper() < greatest && depth.lower() > 0.0) {
    const auto below = static_cast<float>(depth.lower());
    if (below == static_cast<float>(depth.upper())) return below;
  }
  ++exact_evaluations_;
  const ExactTriangle& exact = triangles_.one(triangle.id);
  const Dyadic sum = at_sample(exact.oriented.sum, a, b);
  long det_exponent = 0;
  long sum_exponent = 0;
  const double fraction = exact.oriented.det.rounded(det_exponent) / sum.rounded(sum_exponent);
  const double near_the_quotient = std::ldexp(fraction, static_cast<int>(det_exponent - sum_exponent));
  if (near_the_quotient >= greatest) return std::numeric_limits<float>::max();
  // The guess is off by a few units in the 53rd bit, so it is the wanted float or its neighbour.
  auto result = static_cast<float>(near_the_quotient);
  const auto above_middle = [&](float low, float high) {
    const double middle = (double{low} + double{high}) / 2.0;
    const int side = (exact.oriented.det - sum * Dyadic(middle)).sign();
    const bool low_is_even = (std::bit_cast<std::uint32_t>(low) & 1U) == 0U;
    return side > 0 || (side == 0 && !low_is_even);
  };
  const float next = std::nextafter(result, std::numeric_limits<float>::infinity());
  const float previous = std::nextafter(result, 0.0F);
  if (std::isfinite(next) && above_middle(result, next)) return next;
  if (previous < result && !above_middle(previous, result)) return previous;
  return result;
}

}  // namespace hsr
