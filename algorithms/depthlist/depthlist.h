#pragma once

#include "algorithm.h"

namespace hsr {

/// The catalogue's row of the depth lists.
const Algorithm& depthlist_algorithm();

}  // namespace hsr
