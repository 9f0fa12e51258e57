#pragma once

#include <glm/mat4x4.hpp>
#include <optional>

#include "scene/scene.h"

namespace hsr {

/// What one camera makes of one scene: everything that an algorithm is given.
///
/// clip_from_world takes a column vector (x, y, z, 1) in world space to clip space in OpenGL's
/// convention: after division by w, x and y in [-1, 1] are the picture, x to the right, y up. The
/// eye depth of a point is its clip w. Matrix, positions, near and far are the input that "exact"
/// is meant relative to. The scene must outlive the view.
struct View {
  const Scene* scene = nullptr;
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels
  Camera camera;
  glm::dmat4 clip_from_world{1.0};
  double near_depth = 0.0;  ///< nearest eye depth that is seen, scene units
  double far_depth = 0.0;   ///< farthest eye depth that is seen, scene units
};

/// The largest width and height of a picture, in pixels.
inline constexpr int greatest_size = 32768;

/// The view of `scene` from `camera` at width × height pixels. Where near or far is not given it
/// comes from the scene's bounding sphere (default_depth_range). Throws UsageError when a size, the
/// camera or the depth range is impossible (eye on target, up along the view axis, not finite ...).
View make_view(const Scene& scene, const Camera& camera, int width, int height,
               std::optional<double> near_depth = std::nullopt,
               std::optional<double> far_depth = std::nullopt);

/// The sphere about the centre of the scene's bounding box that holds every corner of a triangle.
struct BoundingSphere {
  glm::dvec3 centre{0.0};
  double radius = 0.0;
};
BoundingSphere bounding_sphere(const Scene& scene);

/// A camera that sees the whole bounding sphere of the scene from the front, a little from the
/// right and from above, at the given ratio of width to height.
Camera framing_camera(const Scene& scene, double aspect);

}  // namespace hsr
