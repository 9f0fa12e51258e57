#pragma once

#include <map>
#include <string>

#include "scene/readers/input.h"
#include "scene/scene.h"

namespace hsr {

/// Materials by name.
using MaterialLibrary = std::map<std::string, Material, std::less<>>;

/// Adds the materials of an MTL file to `library`: Kd as colour, d as opacity, or Tr as one minus
/// it where there is no d. A name that is known already keeps its first meaning. What is out of
/// [0, 1] is clamped, what is no number left out, both with a warning. Everything else in the file
/// (textures, shine) has no place in a scene and is passed over.
void read_mtl(const Input& input, MaterialLibrary& library);

}  // namespace hsr
