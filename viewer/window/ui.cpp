#include "window/ui.h"

#include <imgui_internal.h>  // what is shown as text: LogToBuffer

namespace hsr::window {
namespace {

/// The part of a label that is shown, or its name where nothing is.
std::string_view visible_label(std::string_view label) {
  const std::size_t end = label.find("##");
  if (end == 0) return label.substr(2);
  return label.substr(0, end);
}

}  // namespace

void Ui::pause_recording() {
  if (!recorder_.on) return;
  recorder_.words += ImGui::GetCurrentContext()->LogBuffer.c_str();
  recorder_.words += "\n";
  if (ImGui::GetCurrentContext()->LogEnabled) ImGui::LogFinish();
}

void Ui::resume_recording() {
  if (recorder_.on && !ImGui::GetCurrentContext()->LogEnabled) ImGui::LogToBuffer(0);
}

void Ui::begin_panel(const char* name, const ImVec2& corner, const ImVec2& size, ImGuiWindowFlags flags) {
  ImGui::SetNextWindowPos(corner);
  ImGui::SetNextWindowSize(size);
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | flags);
  resume_recording();
}

void Ui::end_panel() {
  pause_recording();
  ImGui::End();
}

void Ui::note(const char* label, const std::string& words) {
  if (recorder_.on) {
    const ImVec2 least = ImGui::GetItemRectMin();
    const ImVec2 greatest = ImGui::GetItemRectMax();
    recorder_.places[std::string(visible_label(label))] = {least.x, least.y, greatest.x, greatest.y};
  }
  if (!words.empty() && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) tip(words);
}

void Ui::tip(const std::string& text) {
  pause_recording();  // the end of a tip would end it for the whole panel
  ImGui::BeginTooltip();
  resume_recording();
  ImGui::PushTextWrapPos(24.0F * em);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  pause_recording();
  ImGui::EndTooltip();
  resume_recording();
}

void Ui::beside(const char* next_label, float gap) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float width = ImGui::CalcTextSize(next_label, nullptr, true).x + 2.0F * style.FramePadding.x;
  const float space = gap >= 0.0F ? gap : style.ItemSpacing.x;
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  if (ImGui::GetItemRectMax().x + space + width <= right) ImGui::SameLine(0.0F, gap);
}

bool Ui::button(const char* label, const std::string& tip) {
  const bool pressed = ImGui::Button(label);
  note(label, tip);
  return pressed;
}

bool Ui::toggle(const char* label, bool on, const std::string& tip) {
  if (on) {
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_SliderGrab));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImGui::GetStyleColorVec4(ImGuiCol_SliderGrab));
  }
  const bool pressed = button(label, tip);
  if (on) ImGui::PopStyleColor(2);
  return pressed;
}

bool Ui::checkbox(const char* label, bool& value, const std::string& tip) {
  const bool changed = ImGui::Checkbox(label, &value);
  note(label, tip);
  return changed;
}

bool Ui::combo(const char* label, std::size_t& chosen, std::span<const std::string_view> names,
               const std::string& tip) {
  const std::string shown(chosen < names.size() ? names[chosen] : std::string_view());
  bool changed = false;
  const bool open = ImGui::BeginCombo(label, shown.c_str());
  if (open) {
    for (std::size_t k = 0; k < names.size(); ++k) {
      const std::string name(names[k]);
      if (ImGui::Selectable(name.c_str(), k == chosen)) {
        changed = k != chosen;
        chosen = k;
      }
      note(name.c_str());
      if (k == chosen) ImGui::SetItemDefaultFocus();
    }
    pause_recording();  // the end of a list would end it for the whole panel
    ImGui::EndCombo();
    resume_recording();
  }
  note(label, open ? std::string() : tip);
  return changed;
}

bool Ui::slider(const char* label, float& value, float least, float greatest, const char* format,
                const std::string& tip, ImGuiSliderFlags flags) {
  const bool changed =
      ImGui::SliderFloat(label, &value, least, greatest, format, flags | ImGuiSliderFlags_AlwaysClamp);
  note(label, tip);
  return changed;
}

bool Ui::slider(const char* label, int& value, int least, int greatest, const std::string& tip) {
  // Numbers over many powers of ten are set by their order of magnitude.
  constexpr int wide = 10000;
  const bool powers = greatest / wide > least;
  const bool changed =
      ImGui::SliderInt(label, &value, least, greatest, "%d",
                       ImGuiSliderFlags_AlwaysClamp | (powers ? ImGuiSliderFlags_Logarithmic : 0));
  note(label, tip);
  return changed;
}

bool Ui::heading(const char* label, bool open_at_first) {
  const bool open = ImGui::CollapsingHeader(
      label, open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
  note(label);
  return open;
}

void Ui::paragraph(const std::string& text) { colored_paragraph(palette.text, text); }

void Ui::faint_paragraph(const std::string& text) { colored_paragraph(palette.faint_text, text); }

void Ui::colored_paragraph(ImU32 color, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::PushTextWrapPos(0.0F);
  ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

void Ui::draw_text(ImDrawList& list, const ImVec2& place, ImU32 color, const std::string& text) {
  list.AddText(place, color, text.c_str(), text.c_str() + text.size());
  record(text);
}

void Ui::record(const std::string& text) {
  if (recorder_.on) recorder_.words += text + "\n";
}

}  // namespace hsr::window
