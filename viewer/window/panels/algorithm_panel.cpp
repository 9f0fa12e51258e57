#include <algorithm>

#include "text_layout.h"
#include "window/panels/algorithm_settings.h"
#include "window/panels/panels.h"
#include "window/variants.h"

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

std::vector<std::string> words_of(const std::string& joined) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= joined.size();) {
    const std::size_t end = std::min(joined.find('+', begin), joined.size());
    words.push_back(joined.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

/// A setting that is some of several words: a check box for each. The last one that is left stays.
void draw_parts_setting(Ui& ui, const Setting& setting, std::string& value) {
  const bool all = value == setting.choices.front();
  const std::vector<std::string> chosen = all ? std::vector<std::string>() : words_of(value);
  ImGui::TextUnformatted(std::string(setting.name).c_str());
  ui.note(std::string(setting.name).c_str(), std::string(setting.meaning));
  std::string joined;
  std::size_t count = 0;
  bool changed = false;
  for (const std::string_view part : setting.parts) {
    const std::string label(part);
    bool used = all || std::ranges::find(chosen, label) != chosen.end();
    ui.beside(("[]  " + label).c_str());
    changed |= ui.checkbox(label.c_str(), used, std::string(setting.meaning));
    if (!used) continue;
    joined += (joined.empty() ? "" : "+") + label;
    ++count;
  }
  if (!changed || count == 0) return;
  value = count == setting.parts.size() ? std::string(setting.choices.front()) : joined;
}

void draw_setting(Ui& ui, AlgorithmSpec& spec, const Setting& setting) {
  std::string& value = spec.settings.find(setting.name)->second;
  if (!setting.parts.empty()) return draw_parts_setting(ui, setting, value);
  ImGui::SetNextItemWidth(-0.4F * ImGui::GetContentRegionAvail().x);
  if (setting.range) return draw_number_setting(ui, setting, value);
  auto chosen = static_cast<std::size_t>(std::ranges::find(setting.choices, value) - setting.choices.begin());
  const std::string label(setting.name);
  if (ui.combo(label.c_str(), chosen, setting.choices, std::string(setting.meaning))) {
    value = setting.choices[chosen];
  }
}

/// The settings that a fast version lacks; whoever changes one of them gets the textbook version.
void draw_textbook_settings(Ui& ui, Session& session) {
  const AlgorithmSpec& spec = session.bench.state.algorithm;
  if (spec.algorithm->variant_of.empty()) return;
  AlgorithmSpec textbook = other_version(spec);
  const Settings before = textbook.settings;
  for (const Setting& setting : textbook.algorithm->settings) {
    if (!spec.settings.contains(setting.name)) draw_setting(ui, textbook, setting);
  }
  if (textbook.settings == before) return;
  session.bench.select_algorithm(textbook);
  session.tell("the fast version has no such setting: this is the textbook's");
}

}  // namespace

void draw_settings(Ui& ui, AlgorithmSpec& spec) {
  for (const Setting& setting : spec.algorithm->settings) draw_setting(ui, spec, setting);
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
  if (ui.button(command ? "Run again" : "Read again",
                command ? "F5" : "F5; it is read again whenever the file changes"))
    bench.run_again();
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
  draw_textbook_settings(ui, session);
  ui.faint_paragraph("Source: " + std::string(spec.algorithm->source));
}

}  // namespace hsr::window
