#include "window/causes.h"

#include <array>

namespace hsr::window {
namespace {

/// By the causes' numbers: Okabe and Ito's colours, lighter on dark ground and darker on light ground.
constexpr std::array<ImU32, cause_count> on_dark = {
    IM_COL32(204, 121, 167, 255), IM_COL32(240, 228, 66, 255), IM_COL32(86, 180, 233, 255),
    IM_COL32(255, 122, 51, 255),  IM_COL32(47, 199, 154, 255), IM_COL32(230, 159, 0, 255),
    IM_COL32(150, 190, 255, 255), IM_COL32(230, 230, 230, 255)};
constexpr std::array<ImU32, cause_count> on_light = {IM_COL32(150, 50, 105, 255), IM_COL32(122, 106, 0, 255),
                                                     IM_COL32(0, 90, 148, 255),   IM_COL32(184, 71, 0, 255),
                                                     IM_COL32(0, 112, 79, 255),   IM_COL32(154, 99, 0, 255),
                                                     IM_COL32(40, 70, 160, 255),  IM_COL32(60, 60, 60, 255)};

void draw_shape(ImDrawList& list, const ImVec2& at, float r, float width, ImU32 ink, Cause cause) {
  const auto line = [&](float x0, float y0, float x1, float y1) {
    list.AddLine({at.x + r * x0, at.y + r * y0}, {at.x + r * x1, at.y + r * y1}, ink, width);
  };
  switch (cause) {
    case Cause::interpenetration:
      line(-1, -1, 1, 1);
      line(-1, 1, 1, -1);
      break;
    case Cause::cyclic_overlap:
      list.AddTriangle({at.x, at.y - r}, {at.x + r, at.y + 0.8F * r}, {at.x - r, at.y + 0.8F * r}, ink,
                       width);
      break;
    case Cause::sort_key:
      list.AddRect({at.x - r, at.y - r}, {at.x + r, at.y + r}, ink, 0.0F, 0, width);
      break;
    case Cause::depth_precision:
      list.AddCircle(at, r, ink, 0, width);
      break;
    case Cause::coverage_precision:
      list.AddQuad({at.x, at.y - r}, {at.x + r, at.y}, {at.x, at.y + r}, {at.x - r, at.y}, ink, width);
      break;
    case Cause::list_overflow:
      line(-1, 0, 1, 0);
      line(0, -1, 0, 1);
      break;
    case Cause::transparency_unsorted:
      line(-1, -0.5F, 1, -0.5F);
      line(-1, 0.5F, 1, 0.5F);
      break;
    case Cause::unknown:
      list.AddCircleFilled(at, 0.4F * r + width / 2.0F, ink);
      break;
  }
}

}  // namespace

ImU32 cause_color(Cause cause, Theme theme) {
  return (theme == Theme::dark ? on_dark : on_light)[static_cast<std::size_t>(cause)];
}

void draw_cause(ImDrawList& list, const ImVec2& middle, float radius, float stroke, Cause cause,
                Theme theme) {
  const ImU32 ground = theme == Theme::dark ? IM_COL32(0, 0, 0, 230) : IM_COL32(255, 255, 255, 230);
  draw_shape(list, middle, radius, 5.0F * stroke, ground, cause);
  draw_shape(list, middle, radius, 2.0F * stroke, cause_color(cause, theme), cause);
}

}  // namespace hsr::window
