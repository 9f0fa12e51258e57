#pragma once

#include "scene/scene.h"

namespace hsr {

/// A closed bumpy sphere of radius about 1 around the origin: each face of a cube is divided into
/// n × n squares, and the squares' corners are pushed out along their direction (x, y, z) to the radius
/// 1 + 0.06 sin(9x + 1) sin(11y + 2) sin(10z + 3) + 0.015 sin 37x sin 41y sin 43z.
/// 12 n² triangles, 6 n² + 2 shared vertices, outward; one face for each square; no material, no
/// camera. n is at least 1.
Scene bumpy_sphere_mesh(int n);

}  // namespace hsr
