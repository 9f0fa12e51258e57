#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/scene.h"

/// The way of a point from the world to a pixel, one named step after the other:
///
///   1. world -> camera      camera_from_world: the eye becomes the origin
///   2. camera -> (clipped)  clip_to_near: what lies before the near plane is cut away
///   3. camera -> screen     screen_from_camera: the perspective divide onto a canvas at depth 1
///   4. screen -> normalized normalized_from_screen: the canvas becomes the square from 0 to 1
///   5. normalized -> raster raster_from_normalized: in units of pixels
///   6. raster -> pixel      pixel_from_raster: the pixel that a point falls into
///
/// Algorithms use all of 1 to 3 at once as one matrix, clip_from_world (see clip_from_camera). Its
/// normalized *device* coordinates are OpenGL's and run from -1 to 1 with y up; the normalized
/// coordinates of step 4 run from 0 to 1 with y down, as raster space does. The two are related by
/// normalized = ((1 + x) / 2, (1 - y) / 2).
namespace hsr {

/// The window in the plane at depth 1 that the picture shows, in units of that plane: from -width/2
/// to width/2 and from -height/2 to height/2.
struct Canvas {
  double width = 2.0;
  double height = 2.0;
};

/// The canvas of a vertical field of view, for pictures with the given ratio of width to height.
Canvas canvas_of(double vertical_fov_degrees, double aspect);

/// Step 1 as a matrix. Camera space: x to the right, y up, z the eye depth, so that the camera looks
/// along +z (OpenGL's camera looks along -z; only the sign of z differs). Column vectors.
glm::dmat4 camera_from_world(const Camera& camera);

/// Step 2: the part of a convex polygon in camera space with depth z >= near_depth (clip_polygon).
/// New corners do not lie before the plane.
std::vector<glm::dvec3> clip_to_near(const std::vector<glm::dvec3>& camera_polygon, double near_depth);

/// Step 3: the perspective divide. The point's depth must not be 0; a point behind the eye (negative
/// depth) lands turned around, which is why step 2 comes first.
glm::dvec2 screen_from_camera(const glm::dvec3& camera_point);

/// Step 4: (0, 0) is the canvas' upper left corner, (1, 1) its lower right one.
glm::dvec2 normalized_from_screen(const glm::dvec2& screen_point, const Canvas& canvas);

/// OpenGL's normalized device coordinates of the same point: from -1 to 1, y up.
glm::dvec2 device_from_normalized(const glm::dvec2& normalized_point);

/// Step 5: (0, 0) is the upper left corner of the image, pixel (i, j) has its centre at
/// (i + 1/2, j + 1/2).
glm::dvec2 raster_from_normalized(const glm::dvec2& normalized_point, int width, int height);

/// Step 6: the pixel that the point falls into: the whole part of each coordinate, *not* rounded. A
/// normalized coordinate of exactly 1 belongs to the last pixel. Points outside the picture give
/// indices outside it (held within the range of int).
glm::ivec2 pixel_from_raster(const glm::dvec2& raster_point, int width, int height);

/// Steps 1 to 3 in OpenGL's convention, for a column vector in camera space: x and y divided by the
/// half canvas, z such that near and far go to -w and w, and w = eye depth.
glm::dmat4 clip_from_camera(const Canvas& canvas, double near_depth, double far_depth);

}  // namespace hsr
