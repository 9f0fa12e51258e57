#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <vector>

#include "frame/painted_faces.h"
#include "scene/progress.h"

namespace hsr {

/// Writes faces in the order in which they are painted as vector graphics of width × height pixels over
/// `backdrop` (linear RGB): a polygon each, with the ids of its triangles, its colour in sRGB and its
/// opacity. Corners are written to 10^-6 of a pixel, edges are crisp, so that at its own size a pixel
/// shows what is painted at its centre.
///
/// Colours are asked to be blended in linear RGB, as the kit does. Programs that blend in sRGB whatever
/// is asked show transparent faces a little differently. Throws InputError on failure and leaves nothing
/// half-written.
void write_svg(const std::vector<PaintedFace>& faces, int width, int height, const glm::vec3& backdrop,
               const std::filesystem::path& file, const Progress& progress = {});

}  // namespace hsr
