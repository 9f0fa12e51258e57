#pragma once

#include "window/session.h"

namespace hsr::window {

/// Moves the parameter of the scene that is to go up and down, by what `seconds` are worth, once the picture
/// of its last value is there: every structure has to be built anew each time.
void move_parameter(Session& session, double seconds);

}  // namespace hsr::window
