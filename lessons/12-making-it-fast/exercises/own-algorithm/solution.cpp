#include "exercise.h"

namespace {

// The product a x b of rows (x, y, w), and of a with (x, y, 1) at a place of the picture.
Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// x, y and w of the corner in clip space; w is the eye depth.
Vector clip_from_corner(const View& view, const Vector& corner) {
  const auto row = [&](int k) {
    const double* m = view.clip_from_world + 4 * k;
    return m[0] * corner.x + m[1] * corner.y + m[2] * corner.z + m[3];
  };
  return {row(0), row(1), row(3)};
}

}  // namespace

// The z-buffer with edge functions in homogeneous coordinates (Olano and Greer 1997): they are right for
// triangles that reach behind the eye, too, so nothing has to be clipped.
void render(const View& view, Picture& picture) {
  // 1. The picture is cleared already.
  // 2. Take the triangles one after the other.
  for (std::uint32_t id = 0; id < view.triangles.size(); ++id) {
    const Triangle& triangle = view.triangles[id];
    Vector c[3];
    for (int k = 0; k < 3; ++k) c[k] = clip_from_corner(view, triangle.corners[k]);
    const Vector e[3] = {cross(c[1], c[2]), cross(c[2], c[0]), cross(c[0], c[1])};
    const double det = dot(c[0], e[0]);
    if (det == 0.0) continue;
    // 3. For each pixel whose centre it covers,
    for (int j = 0; j < view.height; ++j) {
      for (int i = 0; i < view.width; ++i) {
        const Vector p = {(2.0 * i + 1.0) / view.width - 1.0, 1.0 - (2.0 * j + 1.0) / view.height, 1.0};
        const double w0 = dot(e[0], p) / det;
        const double w1 = dot(e[1], p) / det;
        const double w2 = dot(e[2], p) / det;
        if (w0 < 0.0 || w1 < 0.0 || w2 < 0.0) continue;
        // 4. compute the depth there.
        const double inverse = w0 + w1 + w2;
        if (inverse < 1.0 / view.far_depth || inverse > 1.0 / view.near_depth) continue;
        const double depth = 1.0 / inverse;
        // 5. If it is nearer than the stored depth, store it.
        const bool nearer = depth < picture.depth_at(i, j);
        picture.tell_tested(i, j, id, depth, nearer);
        if (nearer) picture.store(i, j, id, depth);
      }
    }
  }
}
