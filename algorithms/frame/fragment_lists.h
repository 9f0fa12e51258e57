#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace hsr {

/// One surface at a pixel's centre, as an algorithm found it.
struct ListFragment {
  std::uint32_t id = background_id;
  float depth = 0.0F;  ///< eye depth, the nearest float
  bool tied = false;   ///< at exactly the same depth as the fragment before it: not blended again
};

/// The depth list of every pixel, row by row from the top left: nearest first, ties by id.
struct FragmentLists {
  std::vector<std::size_t> begin;       ///< per pixel and one more: where its fragments begin
  std::vector<ListFragment> fragments;  ///< of all pixels, one list after the other
};

}  // namespace hsr
