#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "scene/errors.h"

namespace hsr {

/// Adds an option that takes one value and is given at most once. `take` stores the value that it
/// makes of the text, or throws UsageError.
template <typename Take>
CLI::Option* add_value(CLI::App& app, const std::string& names, const std::string& type, Take take,
                       const std::string& help) {
  // The long name is the one that messages use.
  const std::string name = names.substr(names.find("--"));
  const auto take_once = [name, take](const CLI::results_t& texts) {
    if (texts.size() != 1) throw UsageError(name + " is given more than once");
    take(name, texts.front());
    return true;
  };
  return app.add_option(names, take_once, help)->type_name(type)->take_all();
}

/// Adds an option that takes the name of a file.
inline void add_file(CLI::App& app, const std::string& names, const std::string& type,
                     std::optional<std::filesystem::path>& file, const std::string& help) {
  add_value(
      app, names, type, [&file](const auto&, const auto& text) { file = text; }, help);
}

/// Calls `parse`, and puts the option's name before what it complains of.
template <typename Parse>
auto with_option_named(const std::string& option, Parse parse) {
  try {
    return parse();
  } catch (const UsageError& error) {
    throw UsageError(option + ": " + error.what());
  }
}

}  // namespace hsr
