// The perspective division is missing: x and y have to be divided by the depth z, or what is far away is as
// large as what is near.
#include "exercise.h"

Pixel raster_point(Point p, Canvas canvas, int width, int height) {
  const double x_normalized = (p.x + canvas.width / 2) / canvas.width;
  const double y_normalized = (canvas.height / 2 - p.y) / canvas.height;
  Pixel pixel = {static_cast<int>(std::floor(x_normalized * width)),
                 static_cast<int>(std::floor(y_normalized * height))};
  if (x_normalized == 1.0) pixel.i = width - 1;
  if (y_normalized == 1.0) pixel.j = height - 1;
  return pixel;
}
