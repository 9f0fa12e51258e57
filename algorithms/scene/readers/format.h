#pragma once

#include <filesystem>
#include <string_view>

namespace hsr {

/// The formats that scenes are read from.
enum class Format { obj, ply, off, stl_ascii, stl_binary, gltf, glb, unknown };

/// Tells the format of a file by its first words or bytes, and only where these say nothing by the
/// ending of its name (a final .gz left aside).
Format format_of(const std::filesystem::path& file, std::string_view bytes);

/// Whether the format is text, in which a NUL byte has no place.
bool is_text(Format format);

}  // namespace hsr
