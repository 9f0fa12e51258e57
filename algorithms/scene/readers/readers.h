#pragma once

#include "scene/readers/input.h"
#include "scene/scene.h"

namespace hsr {

// One reader a format. Each makes the scene without its name, warns of what it drops, and throws
// InputError, with file, line or byte and reason, when the file cannot be used. The text formats
// are given no NUL bytes.

/// Wavefront OBJ with its MTL files: v (further numbers, w or colours, are ignored), f, usemtl,
/// mtllib; everything else is passed over.
Scene read_obj(const Input& input);

/// Stanford PLY 1.0: ASCII and both binaries; faces as polygons (`face`) or strips (`tristrips`).
Scene read_ply(const Input& input);

/// Geomview OFF: OFF and its variants with normals, colours or texture coordinates (C, N, ST),
/// ASCII, three dimensions.
Scene read_off(const Input& input);

/// Stereolithography, ASCII and binary. Corners are not shared between triangles, as in the file.
Scene read_stl_ascii(const Input& input);
Scene read_stl_binary(const Input& input);

/// glTF 2.0, as JSON or as GLB: the meshes of the default scene with their nodes' transforms, the
/// base colours of their materials, and the first perspective camera.
Scene read_gltf(const Input& input);
Scene read_glb(const Input& input);

}  // namespace hsr
