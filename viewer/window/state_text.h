#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "window/state.h"

namespace hsr::window {

/// The state as text: a line for every value that is not the default, such as "algorithm painter".
std::string state_text(const State& state);

/// Reads such a text. `source` is named in messages, as in "a.hsr:7: ...". Throws InputError for anything
/// that is not a state: an unknown word, a value out of range, a line given twice.
State read_state_text(std::string_view text, const std::string& source);

/// The same from and to a file. Throws InputError; nothing half-written is left.
State read_state_file(const std::filesystem::path& file);
void write_state_file(const State& state, const std::filesystem::path& file);

}  // namespace hsr::window
