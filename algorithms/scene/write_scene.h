#pragma once

#include <filesystem>

#include "scene/progress.h"
#include "scene/scene.h"

namespace hsr {

/// Writes the scene as triangles, in id order and with the same float32 positions bit for bit.
/// The ending chooses the format: .obj (with an .mtl beside it when the scene has materials; nine
/// significant digits) or .ply (binary little-endian). Throws InputError on any failure, and when
/// `progress` asks to stop, and leaves nothing half-written.
void write_scene(const Scene& scene, const std::filesystem::path& file, const Progress& progress = {});

}  // namespace hsr
