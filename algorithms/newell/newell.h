#pragma once

#include "algorithm.h"

namespace hsr {

/// The row of Newell's algorithm.
const Algorithm& newell_algorithm();

}  // namespace hsr
