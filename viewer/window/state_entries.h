#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "window/state.h"

namespace hsr::window {

using StateWords = std::span<const std::string>;

/// One kind of line of a state's text. `write` returns the words after the name, a string for each line, of
/// what differs from the default; `read` takes as many words as `words` says and throws UsageError.
struct StateEntry {
  std::string_view name;
  std::string_view usage;
  std::size_t words;
  bool repeated;
  std::vector<std::string> (*write)(const State&);
  void (*read)(State&, StateWords);
};

/// In the order in which they are written.
std::span<const StateEntry> state_entries();

}  // namespace hsr::window
