#include "exercise.h"

namespace {

// The whole part without std::floor: a cast, and one less where it went the wrong way.
int whole_part(double number) {
  const int cut = static_cast<int>(number);
  return cut > number ? cut - 1 : cut;
}

}  // namespace

Pixel raster_point(Point p, Canvas canvas, int width, int height) {
  // Through OpenGL's device coordinates, from -1 to 1 with y up.
  const double x_device = p.x / (canvas.width / 2 * p.z);
  const double y_device = p.y / (canvas.height / 2 * p.z);
  return {x_device == 1.0 ? width - 1 : whole_part((1 + x_device) / 2 * width),
          y_device == -1.0 ? height - 1 : whole_part((1 - y_device) / 2 * height)};
}
