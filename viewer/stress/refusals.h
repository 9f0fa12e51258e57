#pragma once

#include <string>
#include <vector>

namespace hsr::stress {

/// Something that is no scene or no camera, and what was said of it.
struct Refusal {
  std::string what;  ///< such as "a position of NaN in an OBJ file"
  std::string said;  ///< the error, or the warning with which it was left out; empty if it was taken
  bool refused() const { return !said.empty(); }
};

/// Tries NaN and infinity in positions and cameras, and cameras that are none. Each must be refused.
std::vector<Refusal> try_refusals();

}  // namespace hsr::stress
