#pragma once

#include "algorithm.h"

namespace hsr {

/// The row of the fast version of the painter's algorithm.
const Algorithm& painter_fast_algorithm();

}  // namespace hsr
