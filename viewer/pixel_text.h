#pragma once

#include <filesystem>
#include <string>

#include "failures/pixel_story.h"

namespace hsr {

/// What hsr pixel prints of a pixel's story. Long lists are shortened in the middle.
std::string to_text(const PixelStory& story, const View& view, const AlgorithmSpec& algorithm);

/// Writes the whole story as JSON, piece by piece, as lists may be long.
void write_json(const PixelStory& story, const View& view, const AlgorithmSpec& algorithm,
                const std::filesystem::path& file);

}  // namespace hsr
