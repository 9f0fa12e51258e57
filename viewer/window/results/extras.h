#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "window/results/rendered.h"

namespace hsr::window {

/// How often the algorithm wrote each pixel, row by row: runs it once more and listens.
std::vector<std::uint32_t> count_overdraw(const PictureKey& key, const Surroundings& given,
                                          const Progress& progress);

/// What leaving work out is worth.
struct SkipTimes {
  double with_ms = 0.0;   ///< to render with the skips that are on
  bool too_long = false;  ///< a picture takes so long that nothing was measured
  /// By name of a skip that is on: how much longer it takes without it, milliseconds; less than 0 where the
  /// skip costs more than it saves.
  std::map<std::string, double, std::less<>> saved_ms;
};

/// Renders with and without each skip, in turns, and compares the least times. A slow one is
/// made once each, or not at all.
SkipTimes measure_skips(const PictureKey& key, const Surroundings& given, PreparedRenderers& prepared,
                        const Progress& progress);

}  // namespace hsr::window
