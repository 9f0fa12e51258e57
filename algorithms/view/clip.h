#pragma once

#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

namespace hsr {

/// The part of a convex polygon on the side of a plane where `distance` is not negative (Sutherland
/// and Hodgman 1974, one plane). `distance` takes a corner and must be linear. Corners keep their
/// order; the result is empty or has one corner more at most. New corners are rounded.
///
/// A new corner is reckoned from the end that is nearer to the plane: from one that is 10^30 away,
/// all digits of the other would be lost.
template <class Distance>
std::vector<glm::dvec3> clip_polygon(const std::vector<glm::dvec3>& polygon, Distance distance) {
  std::vector<glm::dvec3> clipped;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const glm::dvec3& from = polygon[k];
    const glm::dvec3& to = polygon[(k + 1) % polygon.size()];
    const double from_distance = distance(from);
    const double to_distance = distance(to);
    if (from_distance >= 0.0) clipped.push_back(from);
    if ((from_distance >= 0.0) != (to_distance >= 0.0)) {
      const bool start_is_nearer = std::abs(from_distance) <= std::abs(to_distance);
      clipped.push_back(start_is_nearer ? from + (from_distance / (from_distance - to_distance)) * (to - from)
                                        : to + (to_distance / (to_distance - from_distance)) * (from - to));
    }
  }
  return clipped;
}

}  // namespace hsr
