#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/progress.h"
#include "scene/scene.h"

namespace hsr {

/// What a reader had to say about a file that it could use.
struct ReadReport {
  std::vector<std::string> warnings;  ///< one line each, with file and line, without "warning: "
  std::uint64_t bytes = 0;            ///< size of the text or data that was parsed, decompressed
};

/// Reads a scene from a file: OBJ with MTL, PLY (ASCII, both binaries), OFF, STL (ASCII, binary),
/// glTF and GLB; each also compressed as .gz. The format is told by content where the ending lies
/// or says nothing.
///
/// Decimals are rounded correctly to float32 once. Polygons are triangulated in place (ear
/// clipping), so primitive ids follow the file's order. What is usable is kept and what is not is
/// dropped with a warning in `report`.
///
/// Throws InputError, with file, line or byte and reason, when the file cannot be used.
Scene read_scene(const std::filesystem::path& file, ReadReport& report, const Progress& progress = {});

}  // namespace hsr
