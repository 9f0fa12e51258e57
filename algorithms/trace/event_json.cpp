#include "trace/event_json.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "scene/errors.h"

namespace hsr {

namespace {

using Json = nlohmann::json;

constexpr std::array<std::pair<EventKind, std::string_view>, 22> kinds = {{
    {EventKind::key_given, "key_given"},
    {EventKind::placed, "placed"},
    {EventKind::compared, "compared"},
    {EventKind::exchanged, "exchanged"},
    {EventKind::cycled, "cycled"},
    {EventKind::crossed, "crossed"},
    {EventKind::split, "split"},
    {EventKind::released, "released"},
    {EventKind::painted, "painted"},
    {EventKind::edge_drawn, "edge_drawn"},
    {EventKind::depth_tested, "depth_tested"},
    {EventKind::fragment_stored, "fragment_stored"},
    {EventKind::fragment_dropped, "fragment_dropped"},
    {EventKind::list_sorted, "list_sorted"},
    {EventKind::fragment_taken, "fragment_taken"},
    {EventKind::centre_shown, "centre_shown"},
    {EventKind::ray_started, "ray_started"},
    {EventKind::node_entered, "node_entered"},
    {EventKind::node_passed_by, "node_passed_by"},
    {EventKind::cell_entered, "cell_entered"},
    {EventKind::triangle_tested, "triangle_tested"},
    {EventKind::nearest_replaced, "nearest_replaced"},
}};

// The names of the fields, for writing and reading alike.
template <class Visit>
void visit_whole_numbers(Visit visit) {
  visit("i", &Event::i);
  visit("j", &Event::j);
  visit("p", &Event::p);
  visit("q", &Event::q);
  visit("piece_p", &Event::piece_p);
  visit("piece_q", &Event::piece_q);
  visit("number", &Event::number);
}
template <class Visit>
void visit_flags(Visit visit) {
  visit("passed", &Event::passed);
  visit("blended", &Event::blended);
}
template <class Visit>
void visit_doubles(Visit visit) {
  visit("value", &Event::value);
  visit("other", &Event::other);
}

void append_name(std::string& line, std::string_view name) { line.append(",\"").append(name).append("\":"); }

template <class Number>
void append_number(std::string& line, Number number) {
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  line.append(text.data(), end);
}

template <class Number>
void read_whole_number(const Json& value, std::string_view name, Number& number) {
  const bool fits = value.is_number_unsigned() &&
                    value.get<std::uint64_t>() <= std::uint64_t{std::numeric_limits<Number>::max()};
  if (!fits) throw InputError("\"" + std::string(name) + "\" is not a whole number in range");
  number = value.get<Number>();
}

std::uint64_t read_step(const Json& json) {
  const auto step = json.find("step");
  if (step == json.end() || !step->is_number_unsigned()) throw InputError("\"step\" is not a whole number");
  return step->get<std::uint64_t>();
}

EventKind read_kind(const Json& json) {
  const auto found = json.find("kind");
  if (found == json.end() || !found->is_string()) throw InputError("\"kind\" is missing");
  const std::optional<EventKind> kind = event_kind(found->get_ref<const std::string&>());
  if (!kind) throw InputError("\"kind\" is none that is known");
  return *kind;
}

}  // namespace

std::string_view event_name(EventKind kind) {
  for (const auto& [known, name] : kinds) {
    if (known == kind) return name;
  }
  return "";
}

std::optional<EventKind> event_kind(std::string_view name) {
  for (const auto& [kind, known] : kinds) {
    if (known == name) return kind;
  }
  return std::nullopt;
}

std::string to_json_line(const NumberedEvent& numbered) {
  const Event& event = numbered.event;
  const Event defaults;
  std::string line = "{\"step\":";
  append_number(line, numbered.step);
  line.append(",\"kind\":\"").append(event_name(event.kind)).append("\"");
  visit_whole_numbers([&](std::string_view name, auto field) {
    if (event.*field == defaults.*field) return;
    append_name(line, name);
    append_number(line, event.*field);
  });
  visit_flags([&](std::string_view name, auto field) {
    if (event.*field == defaults.*field) return;
    append_name(line, name);
    line += event.*field ? "true" : "false";
  });
  visit_doubles([&](std::string_view name, auto field) {
    if (event.*field == defaults.*field || !std::isfinite(event.*field)) return;
    append_name(line, name);
    append_number(line, event.*field);
  });
  return line + "}";
}

NumberedEvent event_from_json_line(std::string_view line) {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) throw InputError("it is not a JSON object");
  NumberedEvent numbered;
  numbered.step = read_step(json);
  Event& event = numbered.event;
  event.kind = read_kind(json);
  visit_whole_numbers([&](const char* name, auto field) {
    if (json.contains(name)) read_whole_number(json[name], name, event.*field);
  });
  visit_flags([&](const char* name, auto field) {
    if (!json.contains(name)) return;
    if (!json[name].is_boolean()) throw InputError("\"" + std::string(name) + "\" is neither true nor false");
    event.*field = json[name].get<bool>();
  });
  visit_doubles([&](const char* name, auto field) {
    if (!json.contains(name)) return;
    if (!json[name].is_number()) throw InputError("\"" + std::string(name) + "\" is not a number");
    event.*field = json[name].get<double>();
  });
  return numbered;
}

std::optional<NumberedEvent> EventReader::next() {
  std::string line;
  do {
    ++line_;
    if (!std::getline(stream_, line)) return std::nullopt;
  } while (line.find_first_not_of(" \t\r") == std::string::npos);
  try {
    return event_from_json_line(line);
  } catch (const InputError& error) {
    throw InputError(name_ + ", line " + std::to_string(line_) + ": " + error.what());
  }
}

}  // namespace hsr
