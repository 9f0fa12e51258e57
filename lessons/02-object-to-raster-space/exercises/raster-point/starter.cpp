#include "exercise.h"

// p in camera space (z > 0 is the depth), canvas at depth 1, the result in raster space.
Pixel raster_point(Point p, Canvas canvas, int width, int height) {
  // 1. Camera to screen: the perspective division.
  // 2. Screen to normalized: from 0 to 1, y down, (0, 0) the upper left corner.
  // 3. Normalized to raster: in units of pixels.
  // 4. Raster to pixel: the whole part.
  return {width / 2, height / 2};  // the pixel in the middle, whatever the point
}
