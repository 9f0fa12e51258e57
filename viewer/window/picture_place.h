#pragma once

#include <imgui.h>

#include <glm/vec2.hpp>
#include <optional>

#include "window/layout.h"
#include "window/state.h"

namespace hsr::window {

/// Where a picture stands on the screen: raster coordinates to pixels of the window and back.
struct PicturePlace {
  Area area;          ///< what of the window it may use
  Extent size;        ///< of the picture
  float zoom = 1.0F;  ///< pixels of the window for each of the picture
  ImVec2 origin;      ///< where raster (0, 0) stands

  ImVec2 screen(const glm::dvec2& raster) const {
    return {origin.x + zoom * static_cast<float>(raster.x), origin.y + zoom * static_cast<float>(raster.y)};
  }
  glm::vec2 raster(const ImVec2& place) const {
    return {(place.x - origin.x) / zoom, (place.y - origin.y) / zoom};
  }
  /// The pixel at a place of the window, if there is one.
  std::optional<glm::ivec2> pixel(const ImVec2& place) const;
  bool contains(const ImVec2& place) const;
};

/// The picture in its area: as large as it fits, times the magnification, about the centre.
PicturePlace place_picture(const Area& area, Extent size, float magnification, const glm::vec2& centre);

/// The state's magnification and centre such that `factor` more is magnified and the raster point under
/// `place` stays there.
void magnify_about(State& state, const PicturePlace& now, const ImVec2& place, float factor);

}  // namespace hsr::window
