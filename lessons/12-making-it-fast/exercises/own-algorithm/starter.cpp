#include "exercise.h"

// Shows the nearest triangle at every pixel's centre.
void render(const View& view, Picture& picture) {
  // One way is the z-buffer of lesson 4. Here a box is shown where each triangle's first corner is.
  for (std::uint32_t id = 0; id < view.triangles.size(); ++id) {
    const Vector& corner = view.triangles[id].corners[0];
    const double* m = view.clip_from_world;
    const double x = m[0] * corner.x + m[1] * corner.y + m[2] * corner.z + m[3];
    const double y = m[4] * corner.x + m[5] * corner.y + m[6] * corner.z + m[7];
    const double w = m[12] * corner.x + m[13] * corner.y + m[14] * corner.z + m[15];
    if (w < view.near_depth) continue;
    const int i = static_cast<int>((x / w + 1.0) / 2.0 * view.width);
    const int j = static_cast<int>((1.0 - y / w) / 2.0 * view.height);
    for (int row = std::max(j - 2, 0); row < std::min(j + 3, view.height); ++row) {
      for (int column = std::max(i - 2, 0); column < std::min(i + 3, view.width); ++column)
        picture.store(column, row, id, w);
    }
  }
}
