#include <algorithm>
#include <charconv>
#include <optional>

#include "fuzz/support/check_scene.h"
#include "fuzz/targets.h"
#include "scene/catalog.h"
#include "scene/errors.h"

namespace hsr::fuzz {

namespace {

// What is no number at all counts as small, too: it makes no scene.
bool is_small(std::string_view text) {
  double number = 0.0;
  (void)std::from_chars(text.data(), text.data() + text.size(), number);
  return number <= 12.0;
}

// Whether the words ask for every number of the scene, and only for small ones: a large scene, though
// right, would take all of a fuzzer's time.
bool asks_for_little(std::string_view words) {
  const std::size_t name_end = words.find_first_of(":[");
  const auto entry = std::ranges::find(scene_catalog(), words.substr(0, name_end), &SceneEntry::name);
  if (entry == scene_catalog().end()) return true;
  std::size_t numbers = 0;
  while (words.find_first_of(":=") != std::string_view::npos) {
    words.remove_prefix(words.find_first_of(":=") + 1);
    if (!is_small(words.substr(0, words.find_first_of(":,]")))) return false;
    ++numbers;
  }
  return numbers >= entry->parameters.size();
}

}  // namespace

void built_in_scene(std::string_view bytes) {
  if (!asks_for_little(bytes)) return;
  try {
    const std::optional<Scene> scene = make_built_in_scene(bytes);
    if (scene) check_scene(*scene);
  } catch (const UsageError& error) {
    require(*error.what() != '\0', "an error says something");
  }
}

}  // namespace hsr::fuzz
