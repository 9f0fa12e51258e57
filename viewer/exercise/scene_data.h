#pragma once

#include <filesystem>
#include <ostream>
#include <string>

#include "exercise/texts.h"
#include "view/view.h"

namespace hsr {

/// Writes what the checks of an exercise on whole pictures need, into `folder`: for each line of its scenes
/// the view, its triangles, and the exact answer, as lessons/exercise/scenes.h reads them. Returns the file;
/// an empty path if the exercise has no scenes. Throws InputError.
std::filesystem::path write_scene_data(const Exercise& exercise, const std::filesystem::path& folder);

/// The same for a single view, without the exact answer.
void write_view_data(const View& view, const std::filesystem::path& file);

/// The view that the viewer asks for in the environment (hsr view --from): HSR_SIZE and so on, of the scene
/// HSR_SCENE. Throws UsageError where one of them is missing.
View view_from_environment(const Scene& scene);

}  // namespace hsr
