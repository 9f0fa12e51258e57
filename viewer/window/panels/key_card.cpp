#include <algorithm>

#include "window/actions.h"
#include "window/panels/panels.h"

namespace hsr::window {
namespace {

void draw_group(Ui& ui, const ActionGroup& group) {
  ui.colored_paragraph(ui.palette.accent, group.title);
  if (!ImGui::BeginTable(group.title, 2, ImGuiTableFlags_SizingFixedFit)) return;
  for (const Action& action : group.actions) {
    if (action.meaning == nullptr) continue;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(action.keys);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(action.meaning);
  }
  ImGui::EndTable();
  ImGui::Spacing();
}

}  // namespace

void draw_key_card(Ui& ui, Session& session) {
  if (!session.key_card) return;
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  // Where it has no room, its letters are smaller.
  const ImVec2 room = {58.0F * ui.em, 36.0F * ui.em};
  const float fit = std::min({1.0F, 0.98F * window.x / room.x, 0.98F * window.y / room.y});
  const ImVec2 size = {fit * room.x, fit * room.y};
  const ImVec2 corner = {(window.x - size.x) / 2.0F, (window.y - size.y) / 2.0F};
  ImGui::SetNextWindowFocus();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 2.0F * ui.stroke);
  ui.begin_panel("keys", corner, size, ImGuiWindowFlags_None);
  ImGui::PopStyleVar();
  ImGui::SetWindowFontScale(fit);
  const ImGuiStyle& style = ImGui::GetStyle();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {fit * style.ItemSpacing.x, fit * style.ItemSpacing.y});
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {fit * style.CellPadding.x, fit * style.CellPadding.y});
  const auto groups = action_groups();
  if (ImGui::BeginTable("halves", 2, ImGuiTableFlags_SizingStretchSame)) {
    ImGui::TableNextColumn();
    for (std::size_t k = 0; k < groups.size(); k += 2) draw_group(ui, groups[k]);
    ImGui::TableNextColumn();
    for (std::size_t k = 1; k < groups.size(); k += 2) draw_group(ui, groups[k]);
    if (ui.button("Close", "F1 or Esc")) session.key_card = false;
    ui.faint_paragraph("F1 brings this card back. Rest the mouse on anything to read what it does.");
    ImGui::EndTable();
  }
  ImGui::PopStyleVar(2);
  ui.end_panel();
}

}  // namespace hsr::window
