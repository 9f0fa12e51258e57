#pragma once

#include "algorithm.h"

namespace hsr {

/// The catalogue's row.
const Algorithm& painter_algorithm();

}  // namespace hsr
