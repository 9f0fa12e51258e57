#include "window/panels/cycle_graph.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

#include "view/shading.h"
#include "window/panels/depth_plot.h"

namespace hsr::window {
namespace {

/// More would not be told apart.
constexpr std::size_t most_shown = 12;

void draw_arrow(ImDrawList& list, const glm::vec2& from, const glm::vec2& to, float gap, float head,
                ImU32 color, float width) {
  const glm::vec2 way = glm::normalize(to - from);
  const glm::vec2 start = from + gap * way;
  const glm::vec2 end = to - gap * way;
  const glm::vec2 side(-way.y, way.x);
  const glm::vec2 neck = end - head * way;
  list.AddLine({start.x, start.y}, {neck.x, neck.y}, color, width);
  const glm::vec2 left = neck + 0.5F * head * side;
  const glm::vec2 right = neck - 0.5F * head * side;
  list.AddTriangleFilled({end.x, end.y}, {left.x, left.y}, {right.x, right.y}, color);
}

}  // namespace

void draw_cycle(Ui& ui, const std::vector<std::uint32_t>& cycle, const Scene& scene) {
  if (cycle.size() < 2 || cycle.size() > most_shown) return;
  const float radius = 2.6F * ui.em;
  const float node = 0.9F * ui.em;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const glm::vec2 middle(at.x + radius + 2.0F * node, at.y + radius + 1.2F * node);
  ImGui::Dummy({2.0F * (radius + 2.0F * node), 2.0F * (radius + 1.2F * node)});
  ui.note("cycle", "Each has to be painted before the one its arrow leads to, so none can be the first");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto place = [&](std::size_t k) {
    const float angle =
        2.0F * std::numbers::pi_v<float> * (static_cast<float>(k) / static_cast<float>(cycle.size()) - 0.25F);
    return middle + radius * glm::vec2(std::cos(angle), std::sin(angle));
  };
  for (std::size_t k = 0; k < cycle.size(); ++k) {
    draw_arrow(list, place(k), place((k + 1) % cycle.size()), 1.15F * node, 0.6F * ui.em, ui.palette.text,
               2.0F * ui.stroke);
  }
  for (std::size_t k = 0; k < cycle.size(); ++k) {
    const glm::vec2 centre = place(k);
    list.AddCircleFilled({centre.x, centre.y}, node, screen_color(surface_color(scene, cycle[k])));
    list.AddCircle({centre.x, centre.y}, node, ui.palette.text, 0, ui.stroke);
    const std::string label = std::to_string(cycle[k]);
    const ImVec2 size = ImGui::CalcTextSize(label.c_str());
    list.AddRectFilled({centre.x - size.x / 2.0F - 2.0F, centre.y - size.y / 2.0F},
                       {centre.x + size.x / 2.0F + 2.0F, centre.y + size.y / 2.0F}, IM_COL32(0, 0, 0, 150));
    ui.draw_text(list, {centre.x - size.x / 2.0F, centre.y - size.y / 2.0F}, IM_COL32(255, 255, 255, 255),
                 label);
  }
}

}  // namespace hsr::window
