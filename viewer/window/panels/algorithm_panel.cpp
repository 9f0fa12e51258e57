#include <algorithm>

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

void draw_algorithm_panel(Ui& ui, Session& session) {
  AlgorithmSpec& spec = session.bench.state.algorithm;
  ui.paragraph(std::string(spec.algorithm->title));
  ui.faint_paragraph(std::string(spec.algorithm->idea));
  draw_settings(ui, spec);
  ui.faint_paragraph("Source: " + std::string(spec.algorithm->source));
}

}  // namespace hsr::window
