#pragma once

#include "algorithm.h"

namespace hsr {

/// The row of the fast version of Newell's algorithm.
const Algorithm& newell_fast_algorithm();

}  // namespace hsr
