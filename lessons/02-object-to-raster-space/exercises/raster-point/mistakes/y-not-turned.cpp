// y is not turned round: it points up in camera space, and rows are counted from the top. The picture stands
// on its head.
#include "exercise.h"

Pixel raster_point(Point p, Canvas canvas, int width, int height) {
  const double x_normalized = (p.x / p.z + canvas.width / 2) / canvas.width;
  const double y_normalized = (p.y / p.z + canvas.height / 2) / canvas.height;
  Pixel pixel = {static_cast<int>(std::floor(x_normalized * width)),
                 static_cast<int>(std::floor(y_normalized * height))};
  if (x_normalized == 1.0) pixel.i = width - 1;
  if (y_normalized == 1.0) pixel.j = height - 1;
  return pixel;
}
