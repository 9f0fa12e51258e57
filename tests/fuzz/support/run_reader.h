#pragma once

#include <filesystem>
#include <string_view>

#include "scene/readers/input.h"
#include "scene/scene.h"

namespace hsr::fuzz {

/// Runs a reader on bytes as the content of a file and checks the scene that comes back. An
/// InputError is what a broken file deserves, if it is one line.
void run_reader(Scene (*reader)(const Input&), const std::filesystem::path& file, std::string_view bytes);

/// Throws Broken unless the message is one line, and not an endless one.
void check_message(std::string_view message);

}  // namespace hsr::fuzz
