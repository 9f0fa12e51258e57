#include <imgui.h>
// Needs what stands above.
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "scene/catalog.h"
#include "text_layout.h"
#include "window/panels/panels.h"
#include "window/scene_words.h"

namespace hsr::window {
namespace {

bool contains_word(std::string_view text, std::string_view word) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  return word.empty() || !std::ranges::search(text, word, same).empty();
}

/// The list below the field: what fits the typed words.
void draw_choices(Ui& ui, Session& session) {
  for (const SceneEntry& entry : scene_catalog()) {
    const std::string all =
        std::string(entry.name) + " " + std::string(entry.title) + " " + std::string(entry.shows);
    if (!contains_word(all, session.scene_words)) continue;
    const std::string label = std::string(entry.name) + ": " + std::string(entry.title);
    if (ImGui::Selectable(label.c_str(), false)) {
      session.bench.open_scene(std::string(entry.name));
      ImGui::CloseCurrentPopup();
    }
    ui.note(std::string(entry.name).c_str(), std::string(entry.shows));
  }
}

void draw_picker(Ui& ui, Session& session) {
  if (ui.button("Scene ...",
                "Search a scene or type the name of a file (/). A file can also be dropped on the window.") ||
      session.search_scene) {
    session.search_scene = false;
    session.scene_words.clear();
    ImGui::OpenPopup("scenes");
  }
  const ImVec2 below = {ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + 0.2F * ui.em};
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(SceneWords(session.bench.state.scene).short_name().c_str());
  // Also where a key opened it and the mouse is anywhere.
  ImGui::SetNextWindowPos(below, ImGuiCond_Appearing);
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowSizeConstraints({std::min(26.0F * ui.em, window.x - below.x), 10.0F * ui.em},
                                      {std::min(40.0F * ui.em, window.x - below.x),
                                       std::clamp(window.y - below.y - ui.em, 10.0F * ui.em, 30.0F * ui.em)});
  ui.pause_recording();
  if (ImGui::BeginPopup("scenes")) {
    ui.resume_recording();
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1.0F);
    if (ImGui::InputTextWithHint("##search", "words, or the name of a file", &session.scene_words,
                                 ImGuiInputTextFlags_EnterReturnsTrue)) {
      session.bench.open_scene(best_scene(session.scene_words));
      ImGui::CloseCurrentPopup();
    }
    ui.note("##search");
    draw_choices(ui, session);
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) ImGui::CloseCurrentPopup();
    ui.pause_recording();
    ImGui::EndPopup();
  }
  ui.resume_recording();
}

void draw_parameters(Ui& ui, Session& session) {
  SceneWords words(session.bench.state.scene);
  if (words.entry() == nullptr) return;
  bool changed = false;
  for (std::size_t k = 0; k < words.values().size(); ++k) {
    const SceneParameter& parameter = words.entry()->parameters[k];
    const std::string name(parameter.name);
    ImGui::SetNextItemWidth(0.45F * ImGui::GetContentRegionAvail().x);
    double& value = words.values()[k];
    if (parameter.whole) {
      int number = static_cast<int>(value);
      changed |= ui.slider(name.c_str(), number, static_cast<int>(parameter.least),
                           static_cast<int>(parameter.greatest), std::string(parameter.meaning));
      value = number;
    } else {
      auto number = static_cast<float>(value);
      const bool powers = parameter.greatest > 1000.0 * std::max(parameter.least, 1e-3);
      changed |= ui.slider(name.c_str(), number, static_cast<float>(parameter.least),
                           static_cast<float>(parameter.greatest), "%.3g", std::string(parameter.meaning),
                           powers ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
      value = std::clamp(static_cast<double>(number), parameter.least, parameter.greatest);
    }
    const bool moves = session.moving_parameter == static_cast<int>(k);
    const std::string label = "\xE2\x86\x95##" + name;  // an arrow up and down
    const float button =
        ImGui::CalcTextSize(label.c_str(), nullptr, true).x + 2.0F * ImGui::GetStyle().FramePadding.x;
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - button);
    if (ui.toggle(label.c_str(), moves, "Let it go up and down: everything is built anew for each picture")) {
      session.moving_parameter = moves ? -1 : static_cast<int>(k);
    }
    ui.note(("move " + name).c_str());
  }
  if (changed) {
    session.bench.state.scene = words.text();
    session.bench.state.moved.clear();
  }
}

}  // namespace

void draw_scene_panel(Ui& ui, Session& session) {
  if (ui.button("Lessons ...", "The course: text here, the picture beside it (H)"))
    session.lesson_list = true;
  ImGui::SameLine();
  draw_picker(ui, session);
  draw_parameters(ui, session);
  const SceneWords words(session.bench.state.scene);
  if (words.entry() != nullptr) ui.faint_paragraph(std::string(words.entry()->shows));
  if (const auto model = session.bench.model()) {
    ui.faint_paragraph(counted(model->scene->triangles.size(), "triangle"));
    for (std::size_t k = 0; k < std::min<std::size_t>(model->warnings.size(), 3); ++k) {
      ui.colored_paragraph(ui.palette.warn, model->warnings[k]);
    }
    if (model->warnings.size() > 3) {
      ui.colored_paragraph(ui.palette.warn,
                           "and " + std::to_string(model->warnings.size() - 3) + " more warnings");
    }
  }
  if (!session.bench.state.moved.empty() && ui.button("Put corners back", "Undo what was dragged")) {
    session.bench.state.moved.clear();
  }
}

}  // namespace hsr::window
