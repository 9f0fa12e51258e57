#pragma once

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "window/app.h"
#include "window/script/hands.h"

namespace hsr::window {

using ScriptWords = std::span<const std::string>;

/// What the commands of a script work on.
struct Stage {
  App& app;
  Hands hands;
  std::ostream& out;
  bool takes_screenshots = true;
  std::filesystem::path folder = {};  ///< where screenshots go
  State& state() const { return app.session().bench.state; }
};

/// A command, and how many words come after its name.
struct ScriptCommand {
  static constexpr std::size_t any = std::numeric_limits<std::size_t>::max();

  std::string_view name;
  std::string_view usage;  ///< the words that come after the name
  std::size_t least;       ///< how many of them there must be
  std::size_t most;
  void (*run)(Stage&, ScriptWords);  ///< throws UsageError and InputError
  /// What it sets, where that is all that it does in the end; null for all others.
  void (*set)(State&, ScriptWords) = nullptr;
};

/// Those that set what a person would set, and those that do what hands do, look and measure.
std::span<const ScriptCommand> state_commands();
std::span<const ScriptCommand> hand_commands();

// What the words mean. Each throws UsageError for words that it does not know.

std::string joined(ScriptWords words);
int whole(std::string_view what, const std::string& text, int least, int greatest);
bool on_or_off(const std::string& text);
std::size_t one_of(const std::string& text, std::span<const std::string_view> names);

}  // namespace hsr::window
