#include <algorithm>
#include <vector>

#include "window/panels/panels.h"
#include "window/playing.h"
#include "window/variants.h"

namespace hsr::window {

namespace {

std::string label_of(const Algorithm& algorithm, std::size_t place) {
  // Only the first nine have a key.
  return (place < 9 ? std::to_string(place + 1) + " " : "") + std::string(algorithm.name);
}

std::string tip_of(const Algorithm& algorithm) {
  return std::string(algorithm.title) + ". " + std::string(algorithm.idea);
}

constexpr const char* program_label = "0 program";

void draw_program_button(Ui& ui, Session& session) {
  State& state = session.bench.state;
  if (!state.elsewhere) return;
  if (ui.toggle(program_label, state.show_elsewhere, "The picture of another program, or of a file (0)"))
    state.show_elsewhere = !state.show_elsewhere;
  ImGui::SameLine();
}

const Algorithm& chosen_textbook(const Session& session) {
  return textbook_of(*session.bench.state.algorithm.algorithm);
}

void draw_algorithm_buttons(Ui& ui, Session& session) {
  const std::vector<const Algorithm*> algorithms = textbook_algorithms();
  for (std::size_t k = 0; k < algorithms.size(); ++k) {
    const bool chosen = &chosen_textbook(session) == algorithms[k] && !session.bench.state.show_elsewhere;
    if (ui.toggle(label_of(*algorithms[k], k).c_str(), chosen, tip_of(*algorithms[k]))) {
      session.bench.select_algorithm(quickest_version(parse_algorithm_spec(algorithms[k]->name)));
    }
    ImGui::SameLine();
  }
}

/// Where there is no room for a button each.
void draw_algorithm_list(Ui& ui, Session& session) {
  const std::vector<const Algorithm*> algorithms = textbook_algorithms();
  std::vector<std::string> labels;
  std::size_t chosen = 0;
  for (std::size_t k = 0; k < algorithms.size(); ++k) {
    labels.push_back(label_of(*algorithms[k], k));
    if (&chosen_textbook(session) == algorithms[k]) chosen = k;
  }
  const std::vector<std::string_view> names(labels.begin(), labels.end());
  ImGui::SetNextItemWidth(12.0F * ui.em);
  if (ui.combo("##algorithm", chosen, names, tip_of(*algorithms[chosen]))) {
    session.bench.select_algorithm(quickest_version(parse_algorithm_spec(algorithms[chosen]->name)));
  }
  ImGui::SameLine();
}

constexpr const char* fast_label = "Fast";

void draw_fast_button(Ui& ui, Session& session) {
  const AlgorithmSpec& spec = session.bench.state.algorithm;
  if (fast_version_of(*spec.algorithm) == nullptr) return;
  if (ui.toggle(fast_label, !spec.algorithm->variant_of.empty(), "The fast version, or the textbook's (G)")) {
    session.bench.select_algorithm(other_version(spec));
  }
  ImGui::SameLine();
}

float buttons_width() {
  const ImGuiStyle& style = ImGui::GetStyle();
  const auto width_of = [&style](const std::string& label) {
    return ImGui::CalcTextSize(label.c_str()).x + 2.0F * style.FramePadding.x + style.ItemSpacing.x;
  };
  float width = width_of(fast_label);
  const std::vector<const Algorithm*> algorithms = textbook_algorithms();
  for (std::size_t k = 0; k < algorithms.size(); ++k) width += width_of(label_of(*algorithms[k], k));
  return width;
}

}  // namespace

void draw_bar(Ui& ui, Session& session, const Area& area) {
  State& state = session.bench.state;
  ui.begin_panel("bar", area.corner, area.size,
                 ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollbar);
  const float width = ImGui::CalcTextSize("Steps Outside Lecture Light Keys").x + 6.5F * ui.em;
  draw_program_button(ui, session);
  const float program = state.elsewhere ? ImGui::GetCursorPosX() : 0.0F;
  if (program + buttons_width() + width < ImGui::GetWindowWidth()) {
    draw_algorithm_buttons(ui, session);
  } else {
    draw_algorithm_list(ui, session);
  }
  draw_fast_button(ui, session);
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
