#pragma once

#include "options.h"

namespace hsr {

/// What the words of a command line ask for, every value checked. Throws UsageError.
Command parse_command_line(int argc, const char* const* argv);

}  // namespace hsr
