#include "window/scene_words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>

namespace hsr::window {
namespace {

bool read_number(std::string_view text, const SceneParameter& parameter, double& value) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return false;
  if (!(number >= parameter.least && number <= parameter.greatest)) return false;
  if (parameter.whole && number != std::floor(number)) return false;
  value = number;
  return true;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t at = text.find(separator);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

std::string number_text(double value) {
  std::array<char, 400> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed).ptr;
  return {text.data(), end};
}

}  // namespace

SceneWords::SceneWords(std::string_view words) : words_(words) {
  const std::size_t name_end = words.find_first_of(":[");
  const auto catalog = scene_catalog();
  const auto found = std::ranges::find(catalog, words.substr(0, name_end), &SceneEntry::name);
  if (found == catalog.end()) return;
  std::vector<double> values;
  for (const SceneParameter& parameter : found->parameters) values.push_back(parameter.default_value);
  if (name_end != std::string_view::npos) {
    std::string_view rest = words.substr(name_end + 1);
    const bool by_name = words[name_end] == '[';
    if (by_name && !rest.ends_with(']')) return;
    if (by_name) rest.remove_suffix(1);
    std::size_t place = 0;
    for (std::string_view part : split(rest, by_name ? ',' : ':')) {
      if (by_name) {
        const std::string_view name = part.substr(0, part.find('='));
        const auto parameter = std::ranges::find(found->parameters, name, &SceneParameter::name);
        place = static_cast<std::size_t>(parameter - found->parameters.begin());
        part.remove_prefix(std::min(name.size() + 1, part.size()));
      }
      if (place >= values.size() || !read_number(part, found->parameters[place], values[place])) return;
      ++place;
    }
  }
  entry_ = &*found;
  values_ = std::move(values);
}

std::string SceneWords::text() const {
  if (entry_ == nullptr) return words_;
  std::size_t count = values_.size();
  while (count > 0 && values_[count - 1] == entry_->parameters[count - 1].default_value) --count;
  std::string text(entry_->name);
  for (std::size_t k = 0; k < count; ++k) text += ":" + number_text(values_[k]);
  return text;
}

std::string SceneWords::short_name() const {
  return entry_ != nullptr ? words_ : std::filesystem::path(words_).filename().string();
}

std::string best_scene(std::string_view words) {
  std::error_code ignored;
  if (SceneWords(words).entry() != nullptr || words.empty() || std::filesystem::exists(words, ignored)) {
    return std::string(words);
  }
  for (const SceneEntry& entry : scene_catalog()) {
    if (entry.name.find(words) != std::string_view::npos) return std::string(entry.name);
  }
  for (const SceneEntry& entry : scene_catalog()) {
    if (entry.title.find(words) != std::string_view::npos) return std::string(entry.name);
  }
  return std::string(words);
}

}  // namespace hsr::window
