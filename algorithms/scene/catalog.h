#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace hsr {

/// A number that shapes a built-in scene.
struct SceneParameter {
  std::string_view name;     ///< "n", "gap"
  std::string_view meaning;  ///< one sentence, with the unit
  double default_value;
  double least;
  double greatest;
  bool whole;  ///< only whole numbers
};

/// One row of the scene catalogue.
struct SceneEntry {
  std::string_view name;   ///< as on the command line
  std::string_view title;  ///< a few words for menus
  std::string_view shows;  ///< one sentence on what there is to see
  std::span<const SceneParameter> parameters;
  /// Makes the scene, camera included, from one value per parameter, each within its range.
  Scene (*make)(std::span<const double> values);
};

/// Every built-in scene, in teaching order.
std::span<const SceneEntry> scene_catalog();

/// Makes the built-in scene that `words` names: "box", "soup:20000" (values in the order of the
/// parameters, separated by colons) or "soup[n=20000]". Nothing if the name is not in the
/// catalogue. Throws UsageError if the name is known but a value is not a number in its range.
std::optional<Scene> make_built_in_scene(std::string_view words);

}  // namespace hsr
