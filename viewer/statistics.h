#pragma once

#include <cstddef>
#include <string>

#include "algorithm.h"
#include "scene/scene.h"
#include "view/view.h"

namespace hsr {

/// Everything that `hsr render --stats` tells about how a picture was made.
struct Statistics {
  const AlgorithmSpec* algorithm = nullptr;
  const View* view = nullptr;
  const RenderReport* report = nullptr;
  std::size_t warnings = 0;
  int threads = 1;
  int repeats = 1;
  double load_ms = 0.0;
  double prepare_ms = 0.0;  ///< what no camera changes
  double render_ms = 0.0;   ///< the least of the repeats
};

/// As JSON. Numbers have as many digits as it takes to read the same double back (at most 17).
std::string to_json(const Statistics& statistics);

}  // namespace hsr
