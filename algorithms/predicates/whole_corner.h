#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "predicates/fixed_triangle.h"
#include "predicates/homogeneous.h"

namespace hsr {

/// The sample coordinates (Projection) of a corner where these are exactly whole numbers, as they are where
/// it lies on the row or the column of pixel centres: on grids that somebody drew, then everywhere.
struct WholeCorner {
  std::optional<std::int64_t> a;  ///< |a| < 2^30
  std::optional<std::int64_t> b;
};

/// Of a point whose eye depth is surely above 0. What is not found to be whole may be so all the same where
/// the numbers' exponents differ too much to tell cheaply.
WholeCorner whole_corner(const Projection& projection, const FixedProjection& fixed, const glm::vec3& world);

/// The sign of e_k · p, -1, 0 or 1, at the sample (a, b) of whole numbers, not turned by the sign of det,
/// where `from` is corner k + 1 and `to` corner k + 2 and both lie before the eye. Nothing where what is
/// known of the corners does not settle it.
std::optional<int> edge_sign(const WholeCorner& from, const WholeCorner& to, std::int64_t a, std::int64_t b);

}  // namespace hsr
