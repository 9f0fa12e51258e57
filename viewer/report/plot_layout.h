#pragma once

#include <string>
#include <vector>

#include "report/plot_scale.h"

namespace hsr::report {

inline constexpr double picture_width = 1280.0;  ///< pixels
inline constexpr int font_pixels = 18;
inline constexpr int small_font_pixels = 16;

/// A rectangle of the picture, in pixels from its lower left corner.
struct Area {
  double left = 0.0;
  double bottom = 0.0;
  double width = 0.0;
  double height = 0.0;

  bool meets(const Area& other) const {
    return left < other.left + other.width && other.left < left + width &&
           bottom < other.bottom + other.height && other.bottom < bottom + height;
  }
  bool holds(const Area& other) const {
    return left <= other.left && bottom <= other.bottom && other.left + other.width <= left + width &&
           other.bottom + other.height <= bottom + height;
  }
};

/// The scales of a panel's axes.
struct Scales {
  Scale x;
  Scale y;

  explicit Scales(const Panel& panel);
  bool take(const Point& point) const { return x.takes(point.x) && y.takes(point.y); }
};

/// The picture's height in pixels.
double height_of(const Plot& plot);

/// Where the axes of panel k stand.
Area area_of(const Plot& plot, std::size_t k);

/// A text and its place, and, where that is away from its point, a line to it.
struct PlacedLabel {
  std::string text;
  Area area;
  bool led = false;
  double point_x = 0.0;  ///< in pixels, as the area
  double point_y = 0.0;
};

/// The labels of the points of a panel whose axes stand at `area`, beside their points, where they cover no
/// other label and no mark. Those without room are left out.
std::vector<PlacedLabel> place_labels(const Panel& panel, const Scales& scales, const Area& area);

}  // namespace hsr::report
