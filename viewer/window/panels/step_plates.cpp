#include "window/panels/step_plates.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "text_layout.h"
#include "view/shading.h"
#include "window/panels/depth_plot.h"

namespace hsr::window {
namespace {

constexpr ImU32 paper = IM_COL32(0, 0, 0, 205);
constexpr ImU32 ink_on_paper = IM_COL32(255, 255, 255, 255);

/// Marks that are no more than this part of the plate apart get no label of their own.
constexpr std::size_t most_labels = 4;

}  // namespace

void draw_tag(Ui& ui, ImDrawList& list, const ImVec2& at, ImU32 ink, const char* letter) {
  const float radius = 0.75F * ui.em;
  list.AddCircleFilled(at, radius, ink);
  list.AddCircle(at, radius, IM_COL32(0, 0, 0, 255), 0, ui.stroke);
  const ImVec2 size = ImGui::CalcTextSize(letter);
  ui.draw_text(list, {at.x - size.x / 2.0F, at.y - size.y / 2.0F}, IM_COL32(0, 0, 0, 255), letter);
}

void draw_verdict(Ui& ui, ImDrawList& list, const ImVec2& at, bool good) {
  const float radius = 0.45F * ui.em;
  list.AddCircleFilled(at, 1.5F * radius, paper);
  if (good) {
    list.AddCircleFilled(at, radius, ui.palette.good);
    return;
  }
  const float width = 3.0F * ui.stroke;
  list.AddLine({at.x - radius, at.y - radius}, {at.x + radius, at.y + radius}, ui.palette.bad, width);
  list.AddLine({at.x - radius, at.y + radius}, {at.x + radius, at.y - radius}, ui.palette.bad, width);
}

void draw_depth_plate(Ui& ui, ImDrawList& list, const Area& area, const std::vector<DepthMark>& marks) {
  const float em = ui.em;
  const bool labelled = marks.size() <= most_labels;
  const ImVec2 size = {15.0F * em, (labelled ? 2.6F + 1.2F * static_cast<float>(marks.size()) : 3.8F) * em};
  const ImVec2 at = {area.corner.x + 0.6F * em, area.corner.y + area.size.y - size.y - 0.6F * em};
  list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, paper, 0.3F * em);
  double least = marks.front().depth;
  double greatest = least;
  for (const DepthMark& mark : marks) {
    least = std::min(least, mark.depth);
    greatest = std::max(greatest, mark.depth);
  }
  const double length = greatest > least ? greatest - least : 1.0;
  const float from = at.x + em;
  const float width = size.x - 2.0F * em;
  const float y = at.y + 1.7F * em;
  list.AddLine({from, y}, {from + width, y}, ink_on_paper, ui.stroke);
  ui.draw_text(list, {from, at.y + 0.1F * em}, ink_on_paper, "near");
  ui.draw_text(list, {from + width - ImGui::CalcTextSize("far").x, at.y + 0.1F * em}, ink_on_paper, "far");
  float row = y + 0.6F * em;
  for (const DepthMark& mark : marks) {
    const double part = greatest > least ? (mark.depth - least) / length : 0.5;
    const ImVec2 dot = {from + static_cast<float>(part) * width, y};
    if (mark.filled) {
      list.AddCircleFilled(dot, 0.4F * em, mark.color);
    } else {
      list.AddCircle(dot, 0.45F * em, mark.color, 0, 3.0F * ui.stroke);
    }
    if (!labelled) continue;
    const ImVec2 key = {from + 0.4F * em, row + 0.6F * em};
    if (mark.filled) {
      list.AddCircleFilled(key, 0.35F * em, mark.color);
    } else {
      list.AddCircle(key, 0.38F * em, mark.color, 0, 2.0F * ui.stroke);
    }
    ui.draw_text(list, {from + 1.2F * em, row}, ink_on_paper, mark.label + ": " + significant(mark.depth, 7));
    row += 1.2F * em;
  }
  if (!labelled)
    ui.draw_text(list, {from, y + 0.6F * em}, ink_on_paper, counted(marks.size(), "fragment") + " so far");
}

void draw_depth_bars(Ui& ui, ImDrawList& list, const Area& area, const std::array<double, 2>& p,
                     const std::array<double, 2>& q) {
  const float em = ui.em;
  const ImVec2 size = {std::min(22.0F * em, area.size.x), 4.4F * em};
  const ImVec2 at = {area.corner.x + 0.6F * em, area.corner.y + area.size.y - size.y - 0.6F * em};
  list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, paper, 0.3F * em);
  const double least = std::min(p[0], q[0]);
  const double length = std::max(std::max(p[1], q[1]) - least, 1e-30);
  const float from = at.x + 2.2F * em;
  const float width = size.x - 3.0F * em;
  const auto bar = [&](const std::array<double, 2>& extent, float row, ImU32 ink, const char* letter) {
    const float y = at.y + row;
    const float left = from + width * static_cast<float>((extent[0] - least) / length);
    const float right = from + width * static_cast<float>((extent[1] - least) / length);
    list.AddRectFilled({left, y}, {std::max(right, left + 2.0F * ui.stroke), y + 0.9F * em}, ink);
    ui.draw_text(list, {at.x + 0.6F * em, y - 0.1F * em}, ink_on_paper, letter);
  };
  bar(p, 1.5F * em, ui.palette.first, "P");
  bar(q, 2.9F * em, ui.palette.second, "Q");
  ui.draw_text(list, {from, at.y + 0.2F * em}, ink_on_paper, "near");
  ui.draw_text(list, {from + width - ImGui::CalcTextSize("far").x, at.y + 0.2F * em}, ink_on_paper, "far");
}

void draw_order_plate(Ui& ui, ImDrawList& list, const Area& area, const std::vector<Event>& all,
                      std::uint32_t present, const Scene& scene) {
  const float em = ui.em;
  const float line = ImGui::GetTextLineHeight();
  // In a low picture it leaves room for the plate of depths, and shows the places about the present one.
  constexpr float below = 8.0F;
  const float room = (area.size.y - below * em) / line - 1.6F;
  if (room < 1.0F) return;
  const std::size_t count = std::min(all.size(), static_cast<std::size_t>(room));
  const auto here_at = static_cast<std::size_t>(std::ranges::find(all, present, &Event::p) - all.begin());
  const std::size_t first = std::min(here_at - std::min(here_at, count / 2), all.size() - count);
  const std::span<const Event> order = std::span(all).subspan(first, count);
  const std::string title = "painted in this order";
  float width = ImGui::CalcTextSize(title.c_str()).x;
  std::vector<std::string> lines;
  for (const Event& event : order) {
    std::string text =
        std::to_string(std::uint64_t{event.number} + 1) + ".  triangle " + std::to_string(event.p);
    if (event.value != 0.0) text += "  key " + significant(event.value, 5);
    width = std::max(width, ImGui::CalcTextSize(text.c_str()).x + 2.6F * em);
    lines.push_back(std::move(text));
  }
  const ImVec2 size = {width + em, line * (static_cast<float>(lines.size()) + 1.6F)};
  const ImVec2 at = {area.corner.x + area.size.x - size.x - 0.4F * em, area.corner.y + 0.4F * em};
  list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, paper, 0.3F * em);
  ui.draw_text(list, {at.x + 0.5F * em, at.y + 0.2F * line}, IM_COL32(200, 200, 200, 255), title);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const float y = at.y + line * (static_cast<float>(k) + 1.3F);
    const bool here = order[k].p == present;
    if (here) ui.draw_text(list, {at.x + 0.3F * em, y}, ink_on_paper, "\xE2\x86\x92");
    list.AddRectFilled({at.x + 1.4F * em, y + 0.2F * line}, {at.x + 2.2F * em, y + 0.8F * line},
                       screen_color(surface_color(scene, order[k].p)));
    ui.draw_text(list, {at.x + 2.6F * em, y}, ink_on_paper, lines[k]);
  }
}

}  // namespace hsr::window
