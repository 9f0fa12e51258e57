#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>

#include "stress/family.h"

namespace hsr::stress {

/// A camera at (x, y, distance) that looks along -z. The tangent of half its angle is 1/4 in doubles, as the
/// view computes it too, so that its matrix has no rounding: a picture n pixels high shows distance / 2n
/// units per pixel in the plane z = 0.
Camera exact_camera(double x, double y, double distance);

/// The exact camera for a picture of 65 × 65 pixels at which a unit in the plane z = 0 is a pixel: the
/// centre of pixel (32 + i, 32 - j) lies at (i, j, 0), and all of row 32 in the plane y = 0.
inline Camera odd_camera() { return exact_camera(0.0, 0.0, 130.0); }
inline constexpr int odd_size = 65;

/// The exact camera for a picture of 64 × 64 pixels at which a unit in the plane z = 0 is a pixel, moved by
/// half a pixel: the centre of pixel (31 + i, 32 - j) lies at (i, j, 0). No step of the projection rounds.
inline Camera pixel_camera() { return exact_camera(0.5, 0.5, 128.0); }

/// The number of pixels of which `holds(list)` is true; the list is exact, the nearest first, not empty.
std::uint64_t count_lists(const SeenProblem& seen,
                          const std::function<bool(std::span<const exact::Fragment>)>& holds);

/// Pixels where a triangle is hidden by one that comes after it in the file and is truly nearer: only depth
/// tells what is seen there.
std::uint64_t decided_by_depth(const SeenProblem& seen);

/// Pixels where something is seen.
std::uint64_t covered(const SeenProblem& seen);

/// Pixels where a triangle of id `first` or above is seen.
std::uint64_t seen_from(const SeenProblem& seen, std::uint32_t first);

}  // namespace hsr::stress
