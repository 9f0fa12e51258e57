#pragma once

#include <filesystem>
#include <glm/vec3.hpp>

#include "frame/frame.h"
#include "scene/progress.h"

namespace hsr {

/// Writes the colours as an 8-bit sRGB PNG, laid over `backdrop` (linear RGB). Throws InputError on
/// failure and leaves nothing half-written. Listeners to `progress` cannot stop it.
void write_png(const Frame& frame, const glm::vec3& backdrop, const std::filesystem::path& file,
               const Progress& progress = {});

/// Writes R, G, B, A (FLOAT, linear, premultiplied), Z (FLOAT eye depth, +infinity for background)
/// and id (UINT, 4294967295 for background) as one OpenEXR scan line image. Throws InputError on
/// failure and leaves nothing half-written. Listeners to `progress` cannot stop it.
void write_exr_layers(const Frame& frame, const std::filesystem::path& file, const Progress& progress = {});

}  // namespace hsr
