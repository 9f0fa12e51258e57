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

  struct Saved {
    double ms = 0.0;        ///< less than 0 where the skip costs more than it saves
    bool at_least = false;  ///< the picture without it was given up before it was done
  };
  /// By name of a skip that is on: how much longer it takes without it.
  std::map<std::string, Saved, std::less<>> saved;
};

/// What is measured.
struct SkipsKey {
  PictureKey picture;
  bool patient = false;  ///< also where a picture takes longer than a second
  bool operator==(const SkipsKey&) const = default;
};

/// Renders with and without each skip, in turns, and compares the least times. A slow picture is made once
/// each; one of more than a second only for who is patient.
SkipTimes measure_skips(const SkipsKey& wanted, const Surroundings& given, PreparedRenderers& prepared,
                        const Progress& progress);

}  // namespace hsr::window
