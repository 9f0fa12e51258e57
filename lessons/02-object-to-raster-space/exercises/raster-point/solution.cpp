#include "exercise.h"

Pixel raster_point(Point p, Canvas canvas, int width, int height) {
  const double x_screen = p.x / p.z;
  const double y_screen = p.y / p.z;
  const double x_normalized = (x_screen + canvas.width / 2) / canvas.width;
  const double y_normalized = (canvas.height / 2 - y_screen) / canvas.height;
  Pixel pixel = {static_cast<int>(std::floor(x_normalized * width)),
                 static_cast<int>(std::floor(y_normalized * height))};
  if (x_normalized == 1.0) pixel.i = width - 1;
  if (y_normalized == 1.0) pixel.j = height - 1;
  return pixel;
}
