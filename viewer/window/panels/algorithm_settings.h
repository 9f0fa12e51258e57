#pragma once

#include "algorithm.h"
#include "window/ui.h"

namespace hsr::window {

/// A combo box or a slider for every setting of the algorithm, from its own description.
void draw_settings(Ui& ui, AlgorithmSpec& spec);

}  // namespace hsr::window
