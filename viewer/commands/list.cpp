#include <ostream>
#include <string>
#include <string_view>

#include "algorithm.h"
#include "commands/commands.h"
#include "commands/list_json.h"
#include "scene/catalog.h"
#include "text_layout.h"

namespace hsr {
namespace {

/// Where the texts begin, to the right of the names.
constexpr std::size_t column = 20;

/// A number as one would type it: 20000, 0.001.
std::string plain(double number) {
  std::string text = std::to_string(number);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string scene_as_typed(const SceneEntry& entry) {
  std::string text(entry.name);
  for (const SceneParameter& parameter : entry.parameters) text.append(":").append(parameter.name);
  return text;
}

std::string parameter_text(const SceneParameter& parameter) {
  return std::string(parameter.name) + ": " + std::string(parameter.meaning) + " (" +
         (parameter.whole ? "whole number, " : "") + plain(parameter.least) + " to " +
         plain(parameter.greatest) + ", default " + plain(parameter.default_value) + ")";
}

std::string scenes_text() {
  std::string text;
  for (const SceneEntry& entry : scene_catalog()) {
    text += definition(scene_as_typed(entry), entry.title, 0, column);
    text += definition("", entry.shows, 0, column);
    for (const SceneParameter& parameter : entry.parameters) {
      text += definition("", parameter_text(parameter), 0, column);
    }
  }
  return text + "\n" +
         paragraph(
             "Parameters may be left out or named: soup, soup:5000, soup[n=5000]. A file is named by its "
             "path.");
}

std::string setting_names(const Algorithm& algorithm) {
  std::string names;
  for (const Setting& setting : algorithm.settings)
    names.append(names.empty() ? "" : ", ").append(setting.name);
  return names.empty() ? "none" : names;
}

std::string algorithm_text(const Algorithm& algorithm) {
  std::string title(algorithm.title);
  if (&algorithm == &default_algorithm()) title += " (used unless another is named)";
  std::string text = definition(algorithm.name, title, 0, column);
  const auto line = [&](std::string_view label, std::string_view value) {
    text += definition(label, value, 2, column);
  };
  line("idea", algorithm.idea);
  line("source", algorithm.source);
  if (!algorithm.variant_of.empty()) line("same result as", algorithm.variant_of);
  line("exact", algorithm.traits.exact ? "yes, in its default settings" : "no");
  line("time", algorithm.traits.time);
  line("memory", algorithm.traits.memory);
  line("transparency", algorithm.traits.transparency);
  line("cycles", algorithm.traits.cycles);
  line("settings", setting_names(algorithm));
  if (algorithm.skips.empty()) line("skips", "none");
  for (const Skip& skip : algorithm.skips) {
    line(&skip == algorithm.skips.data() ? "skips" : "",
         std::string(skip.name) + ": " + std::string(skip.meaning));
  }
  return text;
}

std::string algorithms_text() {
  std::string text;
  for (const Algorithm* algorithm : algorithm_catalog()) text += algorithm_text(*algorithm) + "\n";
  return text +
         "Cycles: what happens where triangles overlap in a cycle or cross one another.\n"
         "Growth: n triangles, p pixels, d triangles at a pixel.\n";
}

std::string values_of(const Setting& setting) {
  std::string text;
  for (const std::string_view choice : setting.choices) text.append(text.empty() ? "" : ", ").append(choice);
  if (setting.range) {
    text += (text.empty() ? "" : ", ") + std::to_string(setting.range->least) + " to " +
            std::to_string(setting.range->greatest);
  }
  for (const std::string_view part : setting.parts) {
    text.append(part == setting.parts.front() ? ", or some of " : " + ").append(part);
  }
  return text;
}

std::string settings_text() {
  std::string text;
  for (const Algorithm* algorithm : algorithm_catalog()) {
    text.append(algorithm->name).append("\n");
    if (algorithm->settings.empty()) text += "  no settings\n";
    for (const Setting& setting : algorithm->settings) {
      text += definition(setting.name, values_of(setting), 2, column);
      text += definition("", setting.meaning, 2, column);
    }
    text += "\n";
  }
  return text +
         "The first value is the default and the most accurate. Written zbuffer[depth=unorm16,snap=4].\n";
}

}  // namespace

void run(const ListCommand& command, std::ostream& out) {
  using enum ListCommand::Catalogue;
  switch (command.catalogue) {
    case scenes:
      out << (command.json ? scenes_json() : scenes_text());
      break;
    case algorithms:
      out << (command.json ? algorithms_json() : algorithms_text());
      break;
    case settings:
      out << (command.json ? settings_json() : settings_text());
      break;
  }
}

}  // namespace hsr
