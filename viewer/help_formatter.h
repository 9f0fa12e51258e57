#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "text_layout.h"

namespace hsr {

/// Help in two columns, wrapped to the width of the page.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    std::string label = option->get_name(is_positional, !is_positional);
    if (!is_positional && !option->get_type_name().empty()) label += " " + option->get_type_name();
    return definition(label, option->get_description(), 2, column);
  }
  std::string make_subcommand(const CLI::App* subcommand) const override {
    return definition(subcommand->get_name(), subcommand->get_description(), 2, 12);
  }
  std::string make_description(const CLI::App* app) const override {
    return paragraph(app->get_description()) + "\n";
  }
  std::string make_footer(const CLI::App* app) const override {
    return app->get_footer().empty() ? "" : paragraph(app->get_footer());
  }

 private:
  static constexpr std::size_t column = 26;
};

}  // namespace hsr
