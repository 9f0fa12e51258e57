#include "window/panels/depth_plot.h"

#include <algorithm>
#include <cmath>

#include "frame/srgb.h"
#include "text_layout.h"
#include "view/shading.h"
#include "window/results/bitmap.h"

namespace hsr::window {
namespace {

/// Where depths stand: from 0 to 1.
class Axis {
 public:
  Axis(const std::vector<exact::Fragment>& list, bool log_depth) : log_depth_(log_depth) {
    const double least = value(list.front().depth);
    const double greatest = value(list.back().depth);
    const double margin =
        greatest > least ? 0.04 * (greatest - least) : std::max(0.01 * std::abs(least), 1e-12);
    first_ = least - margin;
    length_ = greatest - least + 2.0 * margin;
  }
  double place(double depth) const { return (value(depth) - first_) / length_; }

 private:
  double value(double depth) const { return log_depth_ ? std::log(depth) : depth; }
  bool log_depth_;
  double first_ = 0.0;
  double length_ = 1.0;
};

/// Fragments are joined to their own order only while single lines can be told apart.
constexpr std::size_t most_lines = 150;

/// Of each fragment in the algorithm's order: whether another one stands on the wrong side of it.
bool crosses(const std::vector<std::uint32_t>& order, std::size_t at) {
  for (std::size_t k = 0; k < order.size(); ++k) {
    if ((k < at) != (order[k] < order[at]) && k != at) return true;
  }
  return false;
}

}  // namespace

ImU32 screen_color(const glm::vec4& premultiplied) {
  const glm::vec4 color = opaque(premultiplied);
  return rgba(srgb8_from_linear(color.r), srgb8_from_linear(color.g), srgb8_from_linear(color.b));
}

void draw_depth_plot(Ui& ui, const Story& story, bool log_depth, Theme /*theme*/) {
  const std::vector<exact::Fragment>& list = story.pixel.list;
  if (list.empty()) return;
  // Painting puts the farthest first; turned round, both orders have the nearest on the left.
  std::vector<std::uint32_t> order = story.own_order;
  if (story.painted) std::ranges::reverse(order);
  const bool with_order = order.size() > 1 && order.size() <= most_lines;
  const float width = ImGui::GetContentRegionAvail().x;
  const float marks = 4.0F * ui.em;
  const float lines = with_order ? 3.0F * ui.em : 0.0F;
  const float text = 1.3F * ui.em;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::Dummy({width, marks + text + (with_order ? lines + text : 0.0F)});
  ui.note("depth plot",
          "Each mark is a surface at this pixel: its place is its depth, its height its opacity");
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRect(at, {at.x + width, at.y + marks}, ui.palette.line);
  const Axis axis(list, log_depth);
  const float thick = std::clamp(0.5F * width / static_cast<float>(list.size()), 1.0F, 0.45F * ui.em);
  const auto mark_x = [&](std::size_t k) {
    return at.x + width * static_cast<float>(axis.place(list[k].depth));
  };
  for (std::size_t k = 0; k < list.size(); ++k) {
    const float x = mark_x(k);
    const float tall = marks * (0.15F + 0.8F * story.colors[k].a);
    const bool shown = list[k].id == story.pixel.id;
    const ImVec2 least = {x - thick / 2.0F, at.y + marks - tall};
    const ImVec2 greatest = {x + thick / 2.0F, at.y + marks};
    draw.AddRectFilled(least, greatest, screen_color(story.colors[k]));
    if (shown)
      draw.AddRect({least.x - 2.0F, least.y - 2.0F}, {greatest.x + 2.0F, greatest.y}, ui.palette.text, 0.0F,
                   0, 2.0F * ui.stroke);
  }
  ui.draw_text(draw, {at.x, at.y + marks}, ui.palette.faint_text,
               "depth " + significant(list.front().depth, 4));
  const std::string end = significant(list.back().depth, 4);
  ui.draw_text(draw, {at.x + width - ImGui::CalcTextSize(end.c_str()).x, at.y + marks}, ui.palette.faint_text,
               end);
  if (!with_order) return;
  const float top = at.y + marks + text;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const float x = at.x + width * (static_cast<float>(k) + 0.5F) / static_cast<float>(order.size());
    const bool wrong = story.painted && crosses(order, k);
    draw.AddLine({mark_x(order[k]), top}, {x, top + lines}, wrong ? ui.palette.bad : ui.palette.faint_text,
                 (wrong ? 2.5F : 1.5F) * ui.stroke);
    draw.AddCircleFilled({x, top + lines}, 0.28F * ui.em, screen_color(story.colors[order[k]]));
  }
  ui.draw_text(
      draw, {at.x, top + lines + 0.2F * ui.em}, ui.palette.faint_text,
      story.painted ? "painted last  \xE2\x86\x90  painted first" : "met first  \xE2\x86\x92  met last");
}

}  // namespace hsr::window
