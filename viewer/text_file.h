#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace hsr {

/// The whole of a small text file. Throws InputError if it cannot be read or has more than `most` bytes.
std::string read_text_file(const std::filesystem::path& file, std::size_t most = 16'000'000);

}  // namespace hsr
