#pragma once

#include <utility>

#include "trace/event.h"

namespace hsr {

// What a textbook algorithm takes as its template parameter `Trace`. It tells its steps by
//
//   if constexpr (Trace::active) trace.add({.kind = EventKind::painted, ...});
//
// so that the version for NoTrace has nothing of it in its machine code.

/// Nobody looks.
struct NoTrace {
  static constexpr bool active = false;
  void add(const Event&) const {}
};

/// Somebody is told every step.
class EventTrace {
 public:
  static constexpr bool active = true;
  explicit EventTrace(EventListener tell) : tell_(std::move(tell)) {}
  void add(const Event& event) const { tell_(event); }

 private:
  EventListener tell_;
};

}  // namespace hsr
