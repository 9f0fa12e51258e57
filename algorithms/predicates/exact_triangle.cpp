#include "predicates/exact_triangle.h"

#include <array>
#include <cstddef>

namespace hsr {

namespace {

// Powers of two, so that ids spread by their low bits. Neighbouring pixels ask about the same few
// triangles; a few dozen entries keep the repeated work of a row of ambiguous pixels away.
constexpr std::size_t triangle_cache_size = 64;
constexpr std::size_t pair_cache_size = 256;

}  // namespace

ExactTriangleCache::ExactTriangleCache(const Projection& projection, const Scene& scene)
    : projection_(projection),
      scene_(scene),
      triangles_(triangle_cache_size),
      same_planes_(pair_cache_size) {}

const ExactTriangle& ExactTriangleCache::one(std::uint32_t id) {
  ExactTriangle& entry = triangles_[id % triangle_cache_size];
  if (entry.id != id) entry = make(id);
  return entry;
}

ExactTriangleCache::Pair ExactTriangleCache::pair(std::uint32_t p, std::uint32_t q) {
  if (p != q && p % triangle_cache_size == q % triangle_cache_size) {
    spare_ = one(p);
    return {spare_, one(q)};
  }
  const ExactTriangle& first = one(p);
  return {first, one(q)};
}

bool ExactTriangleCache::same_plane(std::uint32_t p, std::uint32_t q) {
  if (p == q) return true;
  SamePlane& entry = same_planes_[(p * 31U + q) % pair_cache_size];
  if (entry.p == p && entry.q == q) return entry.same;
  entry = {p, q, true};
  const auto [first, second] = pair(p, q);
  for (std::size_t axis = 0; axis < 3 && entry.same; ++axis) {
    entry.same =
        (first.oriented.sum[axis] * second.oriented.det - second.oriented.sum[axis] * first.oriented.det)
            .sign() == 0;
  }
  return entry.same;
}

ExactTriangle ExactTriangleCache::make(std::uint32_t id) const {
  std::array<Homogeneous<Dyadic>, 3> corner;
  for (std::size_t k = 0; k < 3; ++k) {
    corner[k] = clip_from_world<Dyadic>(projection_, scene_.positions[scene_.triangles[id].corners[k]]);
  }
  ExactTriangle result;
  result.id = id;
  result.oriented = homogeneous_triangle(projection_, corner);
  result.orientation = result.oriented.det.sign();
  if (result.orientation < 0) {
    for (Homogeneous<Dyadic>& edge : result.oriented.edge) edge = {-edge[0], -edge[1], -edge[2]};
    Homogeneous<Dyadic>& sum = result.oriented.sum;
    sum = {-sum[0], -sum[1], -sum[2]};
    result.oriented.det = -result.oriented.det;
  }
  return result;
}

}  // namespace hsr
