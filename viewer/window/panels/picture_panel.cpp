#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "window/panels/corner_handles.h"
#include "window/panels/outside_view.h"
#include "window/panels/overlay_marks.h"
#include "window/panels/overlay_picture.h"
#include "window/panels/panels.h"
#include "window/panels/picture_mouse.h"
#include "window/panels/step_drawing.h"

namespace hsr::window {
namespace {

/// Puts a picture on the screen's texture if it is not there already.
void show(Session& session, ShownPicture& shown, const std::shared_ptr<const void>& source,
          const ScreenPicture& screen, const Frame* frame) {
  const Theme theme = session.bench.state.theme;
  if (shown.source == source && shown.theme == theme) return;
  const glm::vec3 backdrop = palette_of(theme).backdrop;
  Bitmap anew;  // where the theme has changed since the picture was made
  if (frame != nullptr && screen.backdrop != backdrop)
    anew = over_backdrop(frame->color, frame->width, frame->height, backdrop);
  const Bitmap& bitmap = anew.pixels.empty() ? screen.bitmap : anew;
  shown.texture.set(session.renderer, bitmap.width, bitmap.height, bitmap.pixels.data());
  shown.source = source;
  shown.theme = theme;
}

/// Where the two frames show another triangle: bright, over a dim picture.
void show_difference(Session& session, const std::shared_ptr<const void>& first, const Frame& a,
                     const std::shared_ptr<const void>& second, const Frame& b) {
  ShownPicture& shown = session.shown_difference;
  const Theme theme = session.bench.state.theme;
  if (shown.source == first && shown.source2 == second && shown.theme == theme) return;
  constexpr float dim = 0.15F;
  const glm::vec4 bright =
      theme == Theme::dark ? glm::vec4(1.0F, 0.45F, 0.05F, 1.0F) : glm::vec4(0.6F, 0.1F, 0.0F, 1.0F);
  std::vector<glm::vec4> colors(a.color.size());
  for (std::size_t k = 0; k < colors.size(); ++k) {
    const bool differs = k < b.id.size() && (a.id[k] != b.id[k] || a.color[k] != b.color[k]);
    colors[k] = differs ? bright : dim * a.color[k];
  }
  const Bitmap bitmap = over_backdrop(colors, a.width, a.height, palette_of(theme).backdrop);
  shown.texture.set(session.renderer, bitmap.width, bitmap.height, bitmap.pixels.data());
  shown.source = first;
  shown.source2 = second;
  shown.theme = theme;
}

/// What the picture is compared with, if it is there.
struct Other {
  std::shared_ptr<const void> source;
  const Frame* frame = nullptr;
  const ScreenPicture* screen = nullptr;
};

Other other_of(const Workbench& bench) {
  if (bench.state.other) {
    const auto other = bench.other();
    return other ? Other{other, &other->frame, &other->screen} : Other{};
  }
  const auto truth = bench.truth();
  return truth ? Other{truth, &truth->frame, &truth->screen} : Other{};
}

/// Draws the pixels that are seen, and not the others: magnified pictures are much larger than the screen.
void draw_texture(ImDrawList& list, const Texture& texture, const PicturePlace& place) {
  if (texture.get() == nullptr) return;
  const glm::vec2 size(place.size.width, place.size.height);
  const Area& area = place.area;
  const ImVec2 end = {area.corner.x + area.size.x, area.corner.y + area.size.y};
  const glm::vec2 first = glm::clamp(glm::floor(place.raster(area.corner)), glm::vec2(0.0F), size);
  const glm::vec2 last = glm::clamp(glm::ceil(place.raster(end)), glm::vec2(0.0F), size);
  if (first.x >= last.x || first.y >= last.y) return;
  list.AddImage(texture.get(), place.screen(first), place.screen(last), {first.x / size.x, first.y / size.y},
                {last.x / size.x, last.y / size.y});
}

/// The part of an area from its left end to `part` of its width, or from there to the right end.
Area left_part(const Area& area, float part) { return {area.corner, {area.size.x * part, area.size.y}}; }
Area right_part(const Area& area, float part) {
  return {{area.corner.x + area.size.x * part, area.corner.y}, {area.size.x * (1.0F - part), area.size.y}};
}

void draw_clipped(ImDrawList& list, const Texture& texture, const PicturePlace& place, const Area& clip) {
  list.PushClipRect(clip.corner, {clip.corner.x + clip.size.x, clip.corner.y + clip.size.y}, true);
  draw_texture(list, texture, place);
  list.PopClipRect();
}

/// A word on a plate in the picture's corner.
void draw_caption(Ui& ui, ImDrawList& list, const Area& area, const std::string& text) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const float pad = 0.3F * ui.em;
  const ImVec2 corner = {area.corner.x + pad, area.corner.y + pad};
  list.AddRectFilled(corner, {corner.x + size.x + 2.0F * pad, corner.y + size.y + 2.0F * pad},
                     IM_COL32(0, 0, 0, 170), 4.0F * ui.stroke);
  ui.draw_text(list, {corner.x + pad, corner.y + pad}, IM_COL32(255, 255, 255, 255), text);
}

/// The line between the halves of a wiper, and its handle.
void draw_wiper(Ui& ui, Session& session, ImDrawList& list, const Area& area) {
  State& state = session.bench.state;
  const float x = area.corner.x + state.wiper * area.size.x;
  const float half = 0.7F * ui.em;
  ImGui::SetCursorScreenPos({x - half, area.corner.y});
  ImGui::InvisibleButton("wiper", {2.0F * half, std::max(area.size.y, 1.0F)});
  ui.note("wiper", "Drag: left the picture, right what it is compared with");
  if (ImGui::IsItemActive()) {
    state.wiper = std::clamp((ImGui::GetIO().MousePos.x - area.corner.x) / area.size.x, 0.02F, 0.98F);
  }
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  const ImVec2 top = {x, area.corner.y};
  const ImVec2 bottom = {x, area.corner.y + area.size.y};
  list.AddLine(top, bottom, IM_COL32(0, 0, 0, 200), 5.0F * ui.stroke);
  list.AddLine(top, bottom, IM_COL32(255, 255, 255, 255), 2.0F * ui.stroke);
  const ImVec2 middle = {x, area.corner.y + area.size.y / 2.0F};
  list.AddCircleFilled(middle, half, IM_COL32(255, 255, 255, 255));
  list.AddCircle(middle, half, IM_COL32(0, 0, 0, 200), 0, 2.0F * ui.stroke);
}

/// The pictures themselves; returns the areas that show one, each with its caption.
std::vector<std::pair<Area, std::string>> draw_pictures(Ui& ui, Session& session, ImDrawList& list,
                                                        const Area& area, Extent size) {
  const Workbench& bench = session.bench;
  const State& state = bench.state;
  const auto picture = bench.picture();
  const auto moment = state.stepping ? bench.moment() : nullptr;
  if (moment) {
    show(session, session.shown_picture, moment, moment->screen, nullptr);
  } else {
    show(session, session.shown_picture, picture, picture->screen, &picture->frame);
  }
  const std::string own = bench.maker_name();
  const auto place = [&](const Area& where) {
    return place_picture(where, size, state.magnification, state.centre);
  };
  const Other other = state.comparing == Comparing::off ? Other{} : other_of(bench);
  if (other.frame == nullptr) {
    const OverlayPicture overlay = make_overlay_picture(session);
    const Texture& texture = overlay.there ? session.shown_overlay.texture : session.shown_picture.texture;
    draw_clipped(list, texture, place(area), area);
    if (overlay.there) draw_legend(ui, list, area, overlay);
    return {{area, own}};
  }
  show(session, session.shown_other, other.source, *other.screen, other.frame);
  switch (state.comparing) {
    case Comparing::wiper: {
      const Area left = left_part(area, state.wiper);
      const Area right = right_part(area, state.wiper);
      draw_clipped(list, session.shown_picture.texture, place(area), left);
      draw_clipped(list, session.shown_other.texture, place(area), right);
      return {{left, own}, {right, bench.other_name()}};
    }
    case Comparing::side_by_side: {
      const Area left = left_part(area, 0.5F);
      const Area right = right_part(area, 0.5F);
      draw_clipped(list, session.shown_picture.texture, place(left), left);
      draw_clipped(list, session.shown_other.texture, place(right), right);
      return {{left, own}, {right, bench.other_name()}};
    }
    case Comparing::blink: {
      const bool second = std::fmod(session.now, 1.0) >= 0.5;
      draw_clipped(list, second ? session.shown_other.texture : session.shown_picture.texture, place(area),
                   area);
      return {{area, second ? bench.other_name() : own}};
    }
    default:
      show_difference(session, picture, picture->frame, other.source, *other.frame);
      draw_clipped(list, session.shown_difference.texture, place(area), area);
      return {{area, "difference of " + own + " and " + bench.other_name()}};
  }
}

}  // namespace

void draw_picture(Ui& ui, Session& session, const Area& whole) {
  // The view from outside takes the lower part.
  constexpr float outside_part = 0.42F;
  const bool outside = session.bench.state.outside;
  const Area area = {whole.corner,
                     {whole.size.x, outside ? (1.0F - outside_part) * whole.size.y : whole.size.y}};
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.palette.canvas);
  ui.begin_panel("picture", whole.corner, whole.size,
                 ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollbar |
                     ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Workbench& bench = session.bench;
  if (bench.model() && bench.picture()) {
    const State& state = bench.state;
    const Extent size = bench.picture_size();
    const auto shown = draw_pictures(ui, session, list, area, size);
    const bool halves = shown.size() == 2 && state.comparing == Comparing::side_by_side;
    for (std::size_t k = 0; k < (halves ? 2 : 1); ++k) {
      const Area where = halves ? shown[k].first : area;
      const PicturePlace place = place_picture(where, size, state.magnification, state.centre);
      list.PushClipRect(where.corner, {where.corner.x + where.size.x, where.corner.y + where.size.y}, true);
      draw_grid(ui, place, list);
      if (k == 0 && state.overlay == Overlay::errors && !state.stepping) {
        const Area& own = shown.front().first;
        list.PushClipRect(own.corner, {own.corner.x + own.size.x, own.corner.y + own.size.y}, true);
        draw_failures(ui, session, place, list);
        list.PopClipRect();
      }
      if (state.stepping) {
        draw_step(ui, session, place, list);
      } else {
        draw_failing_pair(ui, session, place, list);
      }
      draw_selection(ui, session, place, list);
      list.PopClipRect();
    }
    for (const auto& [where, caption] : shown) draw_caption(ui, list, where, caption);
    const bool wiper = shown.size() == 2 && !halves;
    if (wiper) draw_wiper(ui, session, list, area);
    const bool right_half = halves && ImGui::GetIO().MousePos.x >= shown[1].first.corner.x;
    const Area mouse_area = halves ? shown[right_half ? 1 : 0].first : area;
    if (!halves)
      drag_corners(ui, session, place_picture(area, size, state.magnification, state.centre), list);
    ImGui::SetCursorScreenPos(area.corner);
    ImGui::InvisibleButton("canvas", {std::max(area.size.x, 1.0F), std::max(area.size.y, 1.0F)},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    ui.note("canvas");
    use_mouse(session, place_picture(mouse_area, size, state.magnification, state.centre));
    const Area below = {{whole.corner.x, whole.corner.y + area.size.y},
                        {whole.size.x, whole.size.y - area.size.y}};
    if (outside) draw_outside_view(ui, session, below);
  }
  ui.end_panel();
}

}  // namespace hsr::window
