#pragma once

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>
#include <string_view>
#include <vector>

#include "algorithm.h"
#include "frame/painted_faces.h"
#include "view/screen_triangles.h"

namespace hsr {

inline constexpr std::array<std::string_view, 4> sort_key_choices = {"farthest", "nearest", "mean",
                                                                     "centroid-distance"};
/// The setting of the painter's algorithm.
inline constexpr Setting sort_key_setting = {
    "key",
    "the depth that stands for a triangle: of its farthest or nearest corner, the mean of its three, or the "
    "distance from the eye to its centroid",
    sort_key_choices};

/// The number that stands for each triangle, by one of sort_key_choices.
std::vector<double> sort_keys(const View& view, const ScreenTriangles& set_up, std::string_view key);

/// What is seen of the triangles, in the order in which they are painted: indices into set_up.triangles.
/// `colors` are by id.
std::vector<PaintedFace> painted_triangles(const View& view, const ScreenTriangles& set_up,
                                           const std::vector<std::uint32_t>& order,
                                           const std::vector<glm::vec4>& colors);

}  // namespace hsr
