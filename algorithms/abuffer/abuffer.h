#pragma once

#include "algorithm.h"

namespace hsr {

/// The catalogue's row of the A-buffer.
const Algorithm& abuffer_algorithm();

}  // namespace hsr
