#pragma once

#include <filesystem>
#include <string>

#include "scene/progress.h"

namespace hsr {

/// The whole content of a file as it is. Throws InputError when the file is missing, a folder,
/// unreadable, larger than half of the machine's memory, or a pipe that gives more than 1 GiB.
std::string raw_file_bytes(const std::filesystem::path& file, const Progress& progress);

/// The same, inflated if it is a gzip file (told by content). Throws InputError also when gzip data
/// is broken, cut off, or inflates to more than 16 MiB and more than 100 times its size.
std::string file_bytes(const std::filesystem::path& file, const Progress& progress);

}  // namespace hsr
