// x and y are divided by the distance from the eye. The depth is z, measured along the view axis; only in the
// middle of the picture both are the same.
#include "exercise.h"

Pixel raster_point(Point p, Canvas canvas, int width, int height) {
  const double distance = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
  const double x_normalized = (p.x / distance + canvas.width / 2) / canvas.width;
  const double y_normalized = (canvas.height / 2 - p.y / distance) / canvas.height;
  return {static_cast<int>(std::floor(x_normalized * width)),
          static_cast<int>(std::floor(y_normalized * height))};
}
