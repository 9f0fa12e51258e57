#pragma once

#include <filesystem>

#include "scene/scene.h"

namespace hsr {

/// Writes a Wavefront OBJ file: every position with nine significant digits at most, which read
/// back as the same float32, and every triangle in id order. If the scene has materials, they go to
/// an MTL file of the same name beside it (not beside a pipe or device). Throws InputError.
void write_obj(const Scene& scene, const std::filesystem::path& file);

/// Writes a binary little-endian PLY file: positions and triangles, bit for bit. It has no place
/// for materials. Throws InputError.
void write_ply(const Scene& scene, const std::filesystem::path& file);

}  // namespace hsr
