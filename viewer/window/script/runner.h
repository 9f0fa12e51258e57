#pragma once

#include <filesystem>
#include <iosfwd>

#include "window/app.h"

namespace hsr::window {

/// Does what a script says, a line after the other, by events of the kind that a person's hands make.
/// Throws InputError with file and line at the first line that is wrong or whose expectation fails. Commands
/// and the number of their words are checked before anything is done.
void run_script(App& app, const std::filesystem::path& file, std::ostream& out);

}  // namespace hsr::window
