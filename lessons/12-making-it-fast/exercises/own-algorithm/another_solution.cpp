#include "exercise.h"

// Ray casting: for each pixel the direction d with clip_from_world * d = (x, y, 1), then the nearest hit.
namespace {

Vector minus(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

}  // namespace

void render(const View& view, Picture& picture) {
  const auto row = [&](int k) {
    return Vector{view.clip_from_world[4 * k], view.clip_from_world[4 * k + 1],
                  view.clip_from_world[4 * k + 2]};
  };
  // The inverse of the matrix of the rows x, y and w has these columns, over the determinant.
  const Vector of_x = cross(row(1), row(3));
  const Vector of_y = cross(row(3), row(0));
  const Vector of_w = cross(row(0), row(1));
  const double determinant = dot(row(3), of_w);
  for (int j = 0; j < view.height; ++j) {
    for (int i = 0; i < view.width; ++i) {
      const double x = (2.0 * i + 1.0) / view.width - 1.0;
      const double y = 1.0 - (2.0 * j + 1.0) / view.height;
      const Vector d = {(x * of_x.x + y * of_y.x + of_w.x) / determinant,
                        (x * of_x.y + y * of_y.y + of_w.y) / determinant,
                        (x * of_x.z + y * of_y.z + of_w.z) / determinant};
      for (std::uint32_t id = 0; id < view.triangles.size(); ++id) {
        const Vector* c = view.triangles[id].corners;
        const Vector e1 = minus(c[1], c[0]);
        const Vector e2 = minus(c[2], c[0]);
        const Vector s = minus(view.eye, c[0]);
        const double volume = dot(cross(d, e2), e1);
        if (volume == 0.0) continue;
        const double u = dot(cross(d, e2), s) / volume;
        const double v = dot(cross(s, e1), d) / volume;
        const double t = dot(cross(s, e1), e2) / volume;
        if (u < 0.0 || v < 0.0 || u + v > 1.0 || t < view.near_depth || t > view.far_depth) continue;
        if (t < picture.depth_at(i, j)) picture.store(i, j, id, t);
      }
    }
  }
}
