#include <algorithm>

#include "nearest_name.h"
#include "scene/errors.h"
#include "values.h"
#include "window/script/script_command.h"

namespace hsr::window {

std::string joined(ScriptWords words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

int whole(std::string_view what, const std::string& text, int least, int greatest) {
  return parse_whole_number(what, text, least, greatest);
}

bool on_or_off(const std::string& text) {
  if (text == "on") return true;
  if (text == "off") return false;
  throw UsageError("\"" + text + "\" is not on or off");
}

std::size_t one_of(const std::string& text, std::span<const std::string_view> names) {
  const auto found = std::ranges::find(names, text);
  if (found == names.end()) throw UsageError("unknown word \"" + text + "\"" + what_there_is(text, names));
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace hsr::window
