#pragma once

#include <glm/vec3.hpp>

#include "scene/built_in/mesh_builder.h"

namespace hsr {

/// Adds the teapot with a material for each part: y up, standing on y = 0 about the origin, 3.15 high
/// and 6.43 from handle to spout, then scaled and moved by `offset`. Each patch becomes
/// subdivision × subdivision squares of two triangles, each square a face, turned outward; squares
/// at the poles of lid and bottom have lost a side and are one triangle. There are no cracks between
/// patches: vertices are shared across their edges. It is open where the original is: between lid
/// and rim, and at the ends of handle and spout. `subdivision` is in
/// [2, 64]: with 1, triangles of the handle would have no area.
void add_teapot(MeshBuilder& builder, int subdivision, double scale, const glm::dvec3& offset);

}  // namespace hsr
