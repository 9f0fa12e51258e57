#pragma once

#include <span>
#include <string>

#include "window/app.h"

namespace hsr::window {

/// Checks `text WORDS`, `no text WORDS`, or a value, a comparison and what it is compared with. Throws
/// InputError that says what was expected and what is, UsageError where the words make no sense.
void check_expectation(App& app, std::span<const std::string> words);

}  // namespace hsr::window
