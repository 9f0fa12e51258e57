#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include "trace/event.h"

namespace hsr {

/// The name of a kind of step, as in the enumeration: "depth_tested".
std::string_view event_name(EventKind kind);
std::optional<EventKind> event_kind(std::string_view name);

/// A step and its number in the run, counted from 1.
struct NumberedEvent {
  std::uint64_t step = 0;
  Event event;

  bool operator==(const NumberedEvent&) const = default;
};

/// The step as a JSON object on one line, without a line break at the end:
///
///   {"step":17,"kind":"compared","p":3,"q":7,"number":4,"passed":true}
///
/// The names are those of the fields of Event; a field that has its default value is left out.
/// Numbers are written so that reading them gives the same double.
std::string to_json_line(const NumberedEvent& numbered);

/// Reads such a line. Throws InputError that says what is wrong with it.
NumberedEvent event_from_json_line(std::string_view line);

/// Reads the steps that --jsonl wrote, one after the other, in memory for one.
class EventReader {
 public:
  /// `name` is that of the stream in messages.
  EventReader(std::istream& stream, std::string name) : stream_(stream), name_(std::move(name)) {}

  /// The next step; nothing at the end. Throws InputError with name and line.
  std::optional<NumberedEvent> next();

 private:
  std::istream& stream_;
  std::string name_;
  std::uint64_t line_ = 0;
};

}  // namespace hsr
