// The coordinate is multiplied by width - 1 and height - 1. The canvas is as wide as all pixels together,
// which are width of them, so 1 has to become width.
#include "exercise.h"

Pixel raster_point(Point p, Canvas canvas, int width, int height) {
  const double x_normalized = (p.x / p.z + canvas.width / 2) / canvas.width;
  const double y_normalized = (canvas.height / 2 - p.y / p.z) / canvas.height;
  return {static_cast<int>(std::floor(x_normalized * (width - 1))),
          static_cast<int>(std::floor(y_normalized * (height - 1)))};
}
