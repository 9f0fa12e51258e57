#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace exercise {

/// A point or direction: in the world, or x, y and w in clip space.
struct Vector {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

/// A triangle in the world, scene units. Its id is its place in View::triangles.
struct Triangle {
  Vector corners[3];
  float color[4] = {0, 0, 0, 1};  ///< linear, premultiplied, and opacity; for whoever wants it
};

/// What is to be shown, from where.
struct View {
  int width = 0;  ///< pixels, as is height
  int height = 0;
  /// Row by row; takes (x, y, z, 1) in the world to clip space, in OpenGL's convention: after division by w,
  /// x and y run from -1 to 1 over the picture, y up. w is the eye depth.
  double clip_from_world[16] = {};
  Vector eye;  ///< in the world
  double near_depth =
      0.0;  ///< what is nearer, or farther than far_depth, is not seen; eye depths, scene units
  double far_depth = 0.0;
  std::vector<Triangle> triangles;
};

/// What is shown: begins as background everywhere, infinitely far away.
class Picture {
 public:
  Picture(int width, int height)
      : width_(width),
        id(static_cast<std::size_t>(width * height), 4294967295U),
        depth(static_cast<std::size_t>(width * height), std::numeric_limits<float>::infinity()),
        exact_(static_cast<std::size_t>(width * height), std::numeric_limits<double>::infinity()) {}

  /// The eye depth that pixel (i, j) shows: column from the left, row from the top.
  double depth_at(int i, int j) const { return exact_.at(place(i, j)); }
  std::uint32_t id_at(int i, int j) const { return id.at(place(i, j)); }
  void store(int i, int j, std::uint32_t new_id, double new_depth) {
    id.at(place(i, j)) = new_id;
    depth.at(place(i, j)) = static_cast<float>(new_depth);
    exact_.at(place(i, j)) = new_depth;
  }
  /// Tells the viewer a step: triangle `p` was compared with what pixel (i, j) shows, before it is stored.
  void tell_tested(int i, int j, std::uint32_t p, double p_depth, bool passed) {
    if (!tells_steps) return;
    const std::uint32_t q = id_at(i, j);
    char line[240];
    char old[80] = "";
    if (q != 4294967295U)
      std::snprintf(old, sizeof old, ",\"q\":%u,\"other\":%.17g", static_cast<unsigned>(q), depth_at(i, j));
    const int order = q == 4294967295U ? 0 : p_depth < depth_at(i, j) ? 1 : p_depth == depth_at(i, j) ? 2 : 3;
    std::snprintf(
        line, sizeof line,
        "{\"step\":%zu,\"kind\":\"depth_tested\",\"i\":%d,\"j\":%d,\"p\":%u,\"value\":%.17g,\"number\":%d,"
        "\"passed\":%s%s}\n",
        ++steps_told, i, j, static_cast<unsigned>(p), p_depth, order, passed ? "true" : "false", old);
    steps += line;
  }

 private:
  std::size_t place(int i, int j) const { return static_cast<std::size_t>(j * width_ + i); }
  int width_;

 public:
  std::vector<std::uint32_t> id;  ///< row by row from the top left
  std::vector<float> depth;
  bool tells_steps = false;
  std::string steps;
  std::size_t steps_told = 0;

 private:
  std::vector<double> exact_;
};

}  // namespace exercise

using namespace exercise;

#define EXERCISE_FUNCTION render

/// Shows the nearest triangle at every pixel's centre.
void render(const View& view, Picture& picture);
