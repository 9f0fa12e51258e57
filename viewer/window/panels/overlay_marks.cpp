#include "window/panels/overlay_marks.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace hsr::window {
namespace {

ImU32 color_of(const Palette& palette, Verdict verdict) {
  if (verdict == Verdict::wrong) return palette.bad;
  return verdict == Verdict::hole ? palette.warn : palette.accent;
}

/// A cross for a wrong pixel, a ring for a hole, a square for a leak; dark below, so that it is seen on any
/// colour.
void draw_glyph(ImDrawList& list, const ImVec2& middle, float radius, float stroke, ImU32 color,
                Verdict verdict) {
  const auto draw = [&](ImU32 ink, float width) {
    const ImVec2 least = {middle.x - radius, middle.y - radius};
    const ImVec2 greatest = {middle.x + radius, middle.y + radius};
    if (verdict == Verdict::wrong) {
      list.AddLine(least, greatest, ink, width);
      list.AddLine({least.x, greatest.y}, {greatest.x, least.y}, ink, width);
    } else if (verdict == Verdict::hole) {
      list.AddCircle(middle, radius, ink, 0, width);
    } else {
      list.AddRect(least, greatest, ink, 0.0F, 0, width);
    }
  };
  draw(IM_COL32(0, 0, 0, 230), 4.0F * stroke);
  draw(color, 2.0F * stroke);
}

/// What stands for the failures in a square of the screen.
struct Crowd {
  glm::vec2 sum{0.0F};
  float count = 0.0F;
  Verdict verdict = Verdict::right;
};

}  // namespace

void draw_failures(Ui& ui, Session& session, const PicturePlace& place, ImDrawList& list) {
  const auto judgement = session.bench.judgement();
  if (!judgement) return;
  // Squares of the screen in which there is one mark at most, so that there are never too many.
  const float square = std::max(1.6F * ui.em, place.zoom);
  std::map<std::pair<int, int>, Crowd> crowds;
  for (const std::uint32_t pixel : judgement->failed) {
    const glm::vec2 raster(static_cast<float>(pixel % static_cast<std::uint32_t>(place.size.width)) + 0.5F,
                           static_cast<float>(pixel / static_cast<std::uint32_t>(place.size.width)) + 0.5F);
    const ImVec2 at = place.screen(raster);
    if (!place.contains(at)) continue;
    Crowd& crowd = crowds[{static_cast<int>(at.x / square), static_cast<int>(at.y / square)}];
    crowd.sum += glm::vec2(at.x, at.y);
    crowd.count += 1.0F;
    crowd.verdict = std::max(crowd.verdict, judgement->verdicts[pixel]);
  }
  const float radius = std::min(0.32F * ui.em, 0.4F * square);
  for (const auto& [cell, crowd] : crowds) {
    const glm::vec2 middle = crowd.sum / crowd.count;
    draw_glyph(list, {middle.x, middle.y}, radius, ui.stroke, color_of(ui.palette, crowd.verdict),
               crowd.verdict);
  }
}

void draw_grid(Ui& ui, const PicturePlace& place, ImDrawList& list) {
  if (place.zoom < 8.0F) return;
  const ImVec2 least = place.area.corner;
  const ImVec2 greatest = {least.x + place.area.size.x, least.y + place.area.size.y};
  const glm::vec2 first = place.raster(least);
  const glm::vec2 last = place.raster(greatest);
  const float right = std::min(place.screen({place.size.width, 0}).x, greatest.x);
  const float bottom = std::min(place.screen({0, place.size.height}).y, greatest.y);
  const ImU32 color = IM_COL32(128, 128, 128, 90);
  for (int i = std::max(0, static_cast<int>(first.x));
       i <= std::min(place.size.width, static_cast<int>(last.x) + 1); ++i) {
    const float x = place.screen({i, 0}).x;
    list.AddLine({x, std::max(place.origin.y, least.y)}, {x, bottom}, color, ui.stroke);
  }
  for (int j = std::max(0, static_cast<int>(first.y));
       j <= std::min(place.size.height, static_cast<int>(last.y) + 1); ++j) {
    const float y = place.screen({0, j}).y;
    list.AddLine({std::max(place.origin.x, least.x), y}, {right, y}, color, ui.stroke);
  }
}

void draw_selection(Ui& ui, Session& session, const PicturePlace& place, ImDrawList& list) {
  if (!session.bench.state.pixel) return;
  const glm::ivec2 pixel = *session.bench.state.pixel;
  ImVec2 least = place.screen({pixel.x, pixel.y});
  ImVec2 greatest = place.screen({pixel.x + 1, pixel.y + 1});
  const float gap = std::max(0.0F, (0.7F * ui.em - (greatest.x - least.x)) / 2.0F);
  least = {least.x - gap, least.y - gap};
  greatest = {greatest.x + gap, greatest.y + gap};
  list.AddRect(least, greatest, IM_COL32(0, 0, 0, 255), 0.0F, 0, 5.0F * ui.stroke);
  list.AddRect(least, greatest, IM_COL32(255, 255, 255, 255), 0.0F, 0, 2.0F * ui.stroke);
}

}  // namespace hsr::window
