#pragma once

#include "algorithm.h"

namespace hsr {

/// The row "raycast-fast" of the catalogue: the rays of 16 × 16 pixels together, exact.
const Algorithm& raycast_fast_algorithm();

}  // namespace hsr
