#include "window/panels/overlay_picture.h"

#include <algorithm>
#include <cmath>

#include "frame/srgb.h"
#include "text_layout.h"
#include "view/shading.h"

namespace hsr::window {
namespace {

constexpr std::uint32_t nothing = rgba(128, 128, 128);

/// Shows numbers by the scale, from the least to the greatest; those that are not finite are grey.
OverlayPicture by_scale(Session& session, const std::vector<float>& values, Extent size) {
  float least = std::numeric_limits<float>::infinity();
  float greatest = -least;
  for (const float value : values) {
    if (!std::isfinite(value)) continue;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  std::vector<std::uint32_t> pixels(values.size(), nothing);
  const float length = greatest > least ? greatest - least : 1.0F;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (std::isfinite(values[k])) pixels[k] = scale_color(static_cast<double>((values[k] - least) / length));
  }
  session.shown_overlay.texture.set(session.renderer, size.width, size.height, pixels.data());
  if (!(greatest >= least)) return {true, "nothing", "nothing"};
  return {true, significant(least, 4), significant(greatest, 4)};
}

OverlayPicture faces(Session& session, const Rendered& picture, Extent size) {
  std::vector<std::uint32_t> pixels;
  pixels.reserve(picture.frame.id.size());
  for (const std::uint32_t id : picture.frame.id) {
    if (id == background_id) {
      pixels.push_back(nothing);
      continue;
    }
    const glm::vec3 color = palette_color(picture.scene->triangles[id].face);
    pixels.push_back(
        rgba(srgb8_from_linear(color.r), srgb8_from_linear(color.g), srgb8_from_linear(color.b)));
  }
  session.shown_overlay.texture.set(session.renderer, size.width, size.height, pixels.data());
  return {true, "", ""};
}

OverlayPicture color_errors(Session& session, const Rendered& picture, const Truth& truth, Extent size) {
  std::vector<float> values;
  for (std::size_t k = 0; k < picture.frame.color.size(); ++k) {
    const glm::vec4 difference = glm::abs(picture.frame.color[k] - truth.frame.color[k]);
    values.push_back(std::max({difference.r, difference.g, difference.b}));
  }
  return by_scale(session, values, size);
}

}  // namespace

OverlayPicture make_overlay_picture(Session& session) {
  const Workbench& bench = session.bench;
  const Overlay overlay = bench.state.overlay;
  if (overlay == Overlay::none || overlay == Overlay::errors || !bench.picture_is_current()) return {};
  const auto picture = bench.picture();
  const auto truth = bench.truth();
  const auto lengths = bench.list_lengths();
  const auto overdraw = bench.overdraw();
  std::shared_ptr<const void> second;
  if (overlay == Overlay::list_length) second = lengths;
  if (overlay == Overlay::color_error) second = truth;
  if (overlay == Overlay::overdraw) second = overdraw;
  const bool needs_second =
      overlay == Overlay::list_length || overlay == Overlay::color_error || overlay == Overlay::overdraw;
  if (needs_second && !second) return {};
  ShownPicture& shown = session.shown_overlay;
  if (shown.source == picture && shown.source2 == second && session.overlay_kind == overlay)
    return session.overlay_made;
  shown.source = picture;
  shown.source2 = second;
  session.overlay_kind = overlay;
  const Extent size = {picture->frame.width, picture->frame.height};
  if (overlay == Overlay::face) return session.overlay_made = faces(session, *picture, size);
  if (overlay == Overlay::depth) return session.overlay_made = by_scale(session, picture->frame.depth, size);
  if (overlay == Overlay::color_error)
    return session.overlay_made = color_errors(session, *picture, *truth, size);
  const std::vector<std::uint32_t>& counts = overlay == Overlay::overdraw ? *overdraw : *lengths;
  return session.overlay_made = by_scale(session, std::vector<float>(counts.begin(), counts.end()), size);
}

void draw_legend(Ui& ui, ImDrawList& list, const Area& area, const OverlayPicture& overlay) {
  if (overlay.least.empty()) return;
  constexpr int parts = 48;
  const float width = 12.0F * ui.em;
  const float height = 0.8F * ui.em;
  const float pad = 0.4F * ui.em;
  const ImVec2 at = {area.corner.x + 2.0F * pad,
                     area.corner.y + area.size.y - height - 1.5F * ui.em - 2.0F * pad};
  list.AddRectFilled({at.x - pad, at.y - pad}, {at.x + width + pad, at.y + height + 1.3F * ui.em + pad},
                     IM_COL32(0, 0, 0, 190), 4.0F * ui.stroke);
  for (int k = 0; k < parts; ++k) {
    const float x = at.x + width * static_cast<float>(k) / parts;
    list.AddRectFilled({x, at.y}, {x + width / parts + 1.0F, at.y + height}, scale_color((k + 0.5) / parts));
  }
  const ImU32 white = IM_COL32(255, 255, 255, 255);
  ui.draw_text(list, {at.x, at.y + height}, white, overlay.least);
  ui.draw_text(list, {at.x + width - ImGui::CalcTextSize(overlay.greatest.c_str()).x, at.y + height}, white,
               overlay.greatest);
}

}  // namespace hsr::window
