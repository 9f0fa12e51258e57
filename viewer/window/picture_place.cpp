#include "window/picture_place.h"

#include <algorithm>
#include <cmath>

namespace hsr::window {
namespace {

constexpr float greatest_zoom = 96.0F;

}  // namespace

bool PicturePlace::contains(const ImVec2& place) const {
  return place.x >= area.corner.x && place.y >= area.corner.y && place.x < area.corner.x + area.size.x &&
         place.y < area.corner.y + area.size.y;
}

std::optional<glm::ivec2> PicturePlace::pixel(const ImVec2& place) const {
  if (!contains(place)) return std::nullopt;
  const glm::vec2 at = raster(place);
  if (!(at.x >= 0.0F && at.y >= 0.0F && at.x < static_cast<float>(size.width) &&
        at.y < static_cast<float>(size.height))) {
    return std::nullopt;
  }
  return glm::ivec2(static_cast<int>(at.x), static_cast<int>(at.y));
}

PicturePlace place_picture(const Area& area, Extent size, float magnification, const glm::vec2& centre) {
  PicturePlace place;
  place.area = area;
  place.size = size;
  const auto width = static_cast<float>(size.width);
  const auto height = static_cast<float>(size.height);
  const float fit = std::min(area.size.x / width, area.size.y / height);
  place.zoom = std::min(fit * magnification, std::max(fit, greatest_zoom));
  // Whole numbers keep pixels square.
  if (place.zoom > 2.0F) place.zoom = std::floor(place.zoom);
  const glm::vec2 middle = magnification > 1.0F ? centre : glm::vec2(0.5F);
  place.origin = {std::round(area.corner.x + area.size.x / 2.0F - place.zoom * middle.x * width),
                  std::round(area.corner.y + area.size.y / 2.0F - place.zoom * middle.y * height)};
  return place;
}

void magnify_about(State& state, const PicturePlace& now, const ImVec2& place, float factor) {
  const auto width = static_cast<float>(now.size.width);
  const auto height = static_cast<float>(now.size.height);
  const float fit = std::min(now.area.size.x / width, now.area.size.y / height);
  const glm::vec2 fixed = now.raster(place);
  state.magnification = std::clamp(state.magnification * factor, 1.0F, std::max(1.0F, greatest_zoom / fit));
  const float zoom = place_picture(now.area, now.size, state.magnification, state.centre).zoom;
  // origin + zoom * fixed = place, and origin follows from the centre.
  state.centre = {
      std::clamp((now.area.corner.x + now.area.size.x / 2.0F - place.x + zoom * fixed.x) / (zoom * width),
                 0.0F, 1.0F),
      std::clamp((now.area.corner.y + now.area.size.y / 2.0F - place.y + zoom * fixed.y) / (zoom * height),
                 0.0F, 1.0F)};
}

}  // namespace hsr::window
