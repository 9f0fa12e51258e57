#pragma once

#include <optional>

#include "fuzz/support/byte_source.h"
#include "scene/scene.h"
#include "view/view.h"

namespace hsr::fuzz {

/// A scene of at most 12 triangles out of bytes. The first byte chooses how coordinates are made:
/// any bits of a float; a coarse lattice, so that corners, edges and planes coincide; the lattice and
/// a few units in the last place beside it; numbers at the borders of float32 and of its exponents.
/// A triangle with a position that is not finite is dropped, as a reader would.
Scene take_scene(ByteSource& source);

/// A small picture and a camera, before it is known of what.
struct Viewpoint {
  int width = 1;
  int height = 1;
  std::optional<Camera> camera;  ///< without it one that frames the scene
  std::optional<double> vertical_fov_degrees;
  std::optional<double> near_depth;
  std::optional<double> far_depth;
};

/// A viewpoint out of bytes: the camera frames the scene, stands on the lattice or anywhere at all;
/// the field of view, near and far are given or not.
Viewpoint take_viewpoint(ByteSource& source);

/// The view of the scene, or nothing where make_view refuses the numbers.
std::optional<View> view_from(const Viewpoint& viewpoint, const Scene& scene);

}  // namespace hsr::fuzz
