#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "trace/event.h"

namespace hsr {

/// A step as hsr prints it, wrapped: "step 17 of 214: P = 3 and Q = 7, ...". The first departure is
/// marked as such.
std::string step_text(std::uint64_t step, std::uint64_t total, const Event& event,
                      std::optional<std::uint64_t> departure);

/// A line that says how many things of a long list are left out: "... 1,234 steps left out ...".
std::string left_out_text(std::uint64_t count, const std::string& noun);

}  // namespace hsr
