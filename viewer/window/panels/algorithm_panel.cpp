#include <algorithm>

#include "text_layout.h"
#include "window/panels/algorithm_settings.h"
#include "window/panels/panels.h"

namespace hsr::window {
namespace {

/// A setting of numbers beside words: a combo for the words, and one that says "number" with a slider.
void draw_number_setting(Ui& ui, const Setting& setting, std::string& value) {
  const bool is_word = std::ranges::find(setting.choices, value) != setting.choices.end();
  std::vector<std::string_view> names(setting.choices.begin(), setting.choices.end());
  names.emplace_back("number");
  std::size_t chosen = names.size() - 1;
  if (is_word) chosen = static_cast<std::size_t>(std::ranges::find(names, value) - names.begin());
  const std::string label(setting.name);
  if (ui.combo(label.c_str(), chosen, names, std::string(setting.meaning))) {
    value = chosen + 1 < names.size() ? std::string(names[chosen]) : std::to_string(setting.range->least);
  }
  if (chosen + 1 < names.size()) return;
  int number = std::atoi(value.c_str());
  ImGui::SetNextItemWidth(-0.4F * ImGui::GetContentRegionAvail().x);
  if (ui.slider(("##number of " + label).c_str(), number, setting.range->least, setting.range->greatest,
                std::string(setting.meaning))) {
    value = std::to_string(number);
  }
}

}  // namespace

void draw_settings(Ui& ui, AlgorithmSpec& spec) {
  for (const Setting& setting : spec.algorithm->settings) {
    std::string& value = spec.settings.find(setting.name)->second;
    ImGui::SetNextItemWidth(-0.4F * ImGui::GetContentRegionAvail().x);
    if (setting.range) {
      draw_number_setting(ui, setting, value);
      continue;
    }
    auto chosen =
        static_cast<std::size_t>(std::ranges::find(setting.choices, value) - setting.choices.begin());
    const std::string label(setting.name);
    if (ui.combo(label.c_str(), chosen, setting.choices, std::string(setting.meaning))) {
      value = setting.choices[chosen];
    }
  }
}

namespace {

/// What is to be said of a program whose pictures are shown.
void draw_program(Ui& ui, Session& session) {
  Workbench& bench = session.bench;
  Elsewhere& elsewhere = *bench.state.elsewhere;
  const bool command = elsewhere.kind == Elsewhere::Kind::command;
  ui.paragraph(command ? "Another program's picture" : "The picture of a file");
  ui.faint_paragraph(elsewhere.words);
  if (command && !elsewhere.allowed) {
    ui.colored_paragraph(ui.palette.warn, "This state wants to run the command above.");
    if (ui.button("Run it", "Only if you know what it does")) elsewhere.allowed = true;
    return;
  }
  if (ui.button(command ? "Run again" : "Read again", "F5")) bench.run_again();
  if (command) {
    ui.faint_paragraph("It may take " + significant(bench.limits.seconds, 3) + " s and " +
                       grouped(bench.limits.memory / 1'000'000) + " MB.");
  }
  if (bench.busy() && !bench.picture_is_current()) {
    ui.faint_paragraph("no picture yet");
  } else if (const std::string problem = bench.elsewhere_problem(); !problem.empty()) {
    ui.colored_paragraph(ui.palette.bad, "\xE2\x9C\x97 " + problem);
  } else if (const auto picture = bench.picture(); picture && picture->told) {
    const ToldPicture& told = picture->told->picture;
    std::string parts = "It tells id and depth";
    if (told.frame.lists) parts += ", lists";
    parts += told.tells_steps ? ", " + counted(told.steps.size(), "step") + "." : ", no steps.";
    ui.faint_paragraph(parts);
    if (!picture->told->said.empty()) ui.faint_paragraph(picture->told->said);
  }
}

}  // namespace

void draw_algorithm_panel(Ui& ui, Session& session) {
  if (session.bench.shows_elsewhere()) return draw_program(ui, session);
  AlgorithmSpec& spec = session.bench.state.algorithm;
  ui.paragraph(std::string(spec.algorithm->title));
  ui.faint_paragraph(std::string(spec.algorithm->idea));
  draw_settings(ui, spec);
  ui.faint_paragraph("Source: " + std::string(spec.algorithm->source));
}

}  // namespace hsr::window
