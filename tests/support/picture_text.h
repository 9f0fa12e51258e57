#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "frame/frame.h"

namespace hsr::test {

/// What a test says of a pixel that is not as it should be: pixel, got, want and a picture of the
/// neighbourhood, nine pixels wide: '#' as it should be, '!' shown where nothing should be, '?'
/// missing, 'x' another triangle, '.' background. Ids are those of both pictures, row by row.
std::string describe_pixel(int i, int j, int width, int height, const std::vector<std::uint32_t>& got,
                           const std::vector<std::uint32_t>& want);

/// Compares ids; empty if they are equal, otherwise describe_pixel of the first that differs and how
/// many do.
std::string difference(const Frame& got, const std::vector<std::uint32_t>& want);

/// Compares two frames in every pixel, bit by bit: ids, depths and colours. Empty if they are equal.
std::string difference(const Frame& got, const Frame& want);

}  // namespace hsr::test
