#pragma once

#include "algorithm.h"

namespace hsr {

/// The catalogue's row.
const Algorithm& abuffer_fast_algorithm();

}  // namespace hsr
