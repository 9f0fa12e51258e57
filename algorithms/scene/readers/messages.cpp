#include "scene/readers/messages.h"

#include <algorithm>
#include <cstddef>

namespace hsr {

std::string place_message(std::string_view file, const Place& place, std::string_view text) {
  std::string message(file);
  if (place.unit == Place::Unit::line) {
    message += ":" + std::to_string(place.number);
  } else if (place.unit == Place::Unit::byte) {
    message += ": byte " + std::to_string(place.number);
  }
  return message.append(": ").append(text);
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string result = "'";
  for (const char c : text.substr(0, longest)) {
    result += c >= ' ' && c <= '~' ? c : '?';
  }
  return result + (text.size() > longest ? "...'" : "'");
}

std::string counted(std::uint64_t number, std::string_view singular, std::string_view plural) {
  return std::to_string(number).append(" ").append(number == 1 ? singular : plural);
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

Warnings::Kind& Warnings::find(std::string_view kind) {
  const auto known =
      std::find_if(kinds_.begin(), kinds_.end(), [&](const Kind& each) { return each.name == kind; });
  return known != kinds_.end() ? *known : kinds_.emplace_back(Kind{std::string(kind), 0, {}});
}

void Warnings::append(const Warnings& other) {
  for (std::string& line : other.lines()) {
    others_.push_back(std::move(line));
  }
}

std::vector<std::string> Warnings::lines() const {
  std::vector<Line> sorted;
  std::vector<std::string> counts;
  for (const Kind& kind : kinds_) {
    sorted.insert(sorted.end(), kind.lines.begin(), kind.lines.end());
    if (kind.count > kept) {
      counts.push_back(file_ + ": and " + std::to_string(kind.count - kept) + " more " + kind.name);
    }
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Line& a, const Line& b) { return a.number < b.number; });
  std::vector<std::string> result;
  result.reserve(sorted.size() + counts.size() + others_.size());
  for (Line& line : sorted) {
    result.push_back(std::move(line.text));
  }
  result.insert(result.end(), counts.begin(), counts.end());
  result.insert(result.end(), others_.begin(), others_.end());
  return result;
}

}  // namespace hsr
