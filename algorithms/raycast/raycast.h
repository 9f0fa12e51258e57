#pragma once

#include "algorithm.h"

namespace hsr {

/// The catalogue's row.
const Algorithm& raycast_algorithm();

}  // namespace hsr
