// The coordinate is cut by a cast to int, which goes towards 0: -0.3 becomes 0 and not -1, so points to the
// left of the picture or above it land inside. std::floor goes down.
#include "exercise.h"

Pixel raster_point(Point p, Canvas canvas, int width, int height) {
  const double x_normalized = (p.x / p.z + canvas.width / 2) / canvas.width;
  const double y_normalized = (canvas.height / 2 - p.y / p.z) / canvas.height;
  Pixel pixel = {static_cast<int>(x_normalized * width), static_cast<int>(y_normalized * height)};
  if (x_normalized == 1.0) pixel.i = width - 1;
  if (y_normalized == 1.0) pixel.j = height - 1;
  return pixel;
}
