// A point on the right or lower border has a normalized coordinate of exactly 1, and there is no column or
// row of that number: it belongs to the last one.
#include "exercise.h"

Pixel raster_point(Point p, Canvas canvas, int width, int height) {
  const double x_normalized = (p.x / p.z + canvas.width / 2) / canvas.width;
  const double y_normalized = (canvas.height / 2 - p.y / p.z) / canvas.height;
  return {static_cast<int>(std::floor(x_normalized * width)),
          static_cast<int>(std::floor(y_normalized * height))};
}
