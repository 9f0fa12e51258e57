#include "window/panels/panels.h"
#include "window/playing.h"

namespace hsr::window {

void draw_bar(Ui& ui, Session& session, const Area& area) {
  State& state = session.bench.state;
  ui.begin_panel("bar", area.corner, area.size,
                 ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollbar);
  const auto algorithms = algorithm_catalog();
  for (std::size_t k = 0; k < algorithms.size(); ++k) {
    const Algorithm& algorithm = *algorithms[k];
    const std::string label = (k < 9 ? std::to_string(k + 1) + " " : "") + std::string(algorithm.name);
    const std::string tip = std::string(algorithm.title) + ". " + std::string(algorithm.idea);
    if (ui.toggle(label.c_str(), state.algorithm.algorithm == &algorithm, tip)) {
      session.bench.select_algorithm(parse_algorithm_spec(algorithm.name));
    }
    ImGui::SameLine();
  }
  const float width = ImGui::CalcTextSize("Steps Outside Lecture Light Keys").x + 6.5F * ui.em;
  ImGui::SameLine(std::max(ImGui::GetCursorPosX(), ImGui::GetWindowWidth() - width));
  if (ui.toggle("Steps", state.stepping, "The algorithm's steps, forward and back (P)"))
    toggle_stepping(session);
  ImGui::SameLine();
  if (ui.toggle("Outside", state.outside, "A second view, from outside (V)")) state.outside = !state.outside;
  ImGui::SameLine();
  if (ui.toggle("Lecture", state.lecture, "Everything larger, fewer panels (L)"))
    state.lecture = !state.lecture;
  ImGui::SameLine();
  const bool dark = state.theme == Theme::dark;
  if (ui.button(dark ? "Light" : "Dark", "Light or dark colours (T)")) {
    state.theme = dark ? Theme::light : Theme::dark;
  }
  ImGui::SameLine();
  if (ui.toggle("Keys", session.key_card, "What the keys do (F1)")) session.key_card = !session.key_card;
  ui.end_panel();
}

}  // namespace hsr::window
