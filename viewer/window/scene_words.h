#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/catalog.h"

namespace hsr::window {

/// The words that name a scene, taken apart: "soup:5000" is the entry soup with the value 5000.
class SceneWords {
 public:
  /// Where the words name no built-in scene, or not rightly, entry() is null and they are kept as they are.
  explicit SceneWords(std::string_view words);

  const SceneEntry* entry() const { return entry_; }
  /// One for each parameter of the entry.
  std::vector<double>& values() { return values_; }
  const std::vector<double>& values() const { return values_; }
  /// The words again; values that are the default are left out if nothing comes after them.
  std::string text() const;
  /// For a line: the words, or of a file its name without folders.
  std::string short_name() const;

 private:
  std::string words_;
  const SceneEntry* entry_ = nullptr;
  std::vector<double> values_;
};

/// The scene that typed words mean: a file or a scene of that name, else the first whose name or title
/// holds the words, else the words themselves.
std::string best_scene(std::string_view words);

}  // namespace hsr::window
