#pragma once

#include <cstdint>
#include <vector>

#include "bands.h"
#include "view/screen_triangles.h"

namespace hsr {

/// Some pixels of a band, and the triangles that may cover them.
struct Part {
  PixelBox box;
  std::vector<std::uint32_t> candidates;  ///< indices into ScreenTriangles::triangles, increasing

  int columns() const { return box.last_i - box.first_i + 1; }
  std::size_t pixel_count() const {
    return static_cast<std::size_t>(columns()) * static_cast<std::size_t>(box.last_j - box.first_j + 1);
  }
  /// The place of a pixel in an array with an entry for each, row by row.
  std::uint32_t place(int i, int j) const {
    return static_cast<std::uint32_t>((j - box.first_j) * columns() + (i - box.first_i));
  }
  /// The part of a triangle's box that lies in this one.
  PixelBox within(const PixelBox& triangle) const {
    return Band{box.first_j, box.last_j + 1, box.first_i, box.last_i}.within(triangle);
  }
};

/// The pixels `box` out of `part`, with the triangles that may cover them.
inline Part part_of(const Part& part, const PixelBox& box, const ScreenTriangles& set_up) {
  Part smaller = {box, {}};
  for (const std::uint32_t index : part.candidates) {
    if (!smaller.within(set_up.boxes[index]).empty()) smaller.candidates.push_back(index);
  }
  return smaller;
}

/// Calls work(part) for parts that together are all pixels of `part`. Work returns false when it found
/// that it would need too much memory; then it is called again for each half of the pixels. A part of
/// a single pixel it must accept.
template <class Work>
void for_each_part(const Part& part, const ScreenTriangles& set_up, Work& work) {
  if (part.box.empty() || work(part)) return;
  PixelBox first = part.box;
  PixelBox second = part.box;
  if (first.last_j > first.first_j) {
    first.last_j = (part.box.first_j + part.box.last_j) / 2;
    second.first_j = first.last_j + 1;
  } else {
    first.last_i = (part.box.first_i + part.box.last_i) / 2;
    second.first_i = first.last_i + 1;
  }
  for_each_part(part_of(part, first, set_up), set_up, work);
  for_each_part(part_of(part, second, set_up), set_up, work);
}

/// The same for a band and every triangle.
template <class Work>
void for_each_part(const Band& band, const ScreenTriangles& set_up, Work work) {
  Part part = {{band.first_i, band.last_i, band.first, band.last - 1}, {}};
  for (std::uint32_t index = 0; index < set_up.boxes.size(); ++index) {
    if (!part.within(set_up.boxes[index]).empty()) part.candidates.push_back(index);
  }
  for_each_part(part, set_up, work);
}

}  // namespace hsr
