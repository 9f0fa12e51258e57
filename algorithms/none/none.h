#pragma once

#include "algorithm.h"

namespace hsr {

/// The catalogue's row.
const Algorithm& none_algorithm();

}  // namespace hsr
