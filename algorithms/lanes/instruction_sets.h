#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace hsr::lanes {

/// The instruction sets that the fast versions were built for and that this machine has, best first:
/// "avx512", "avx2", "sse4", "neon" ... There is at least one.
std::vector<std::string_view> instruction_sets();

/// The place of the instruction set called `name` (one of instruction_sets(), or empty for the best) in the
/// tables that HWY_EXPORT makes. So a choice belongs to a call and not to the program:
///
///   HWY_DISPATCH_TABLE(render_tile)[dispatch_index(options.instruction_set)](...)
///
/// A name that the machine does not have counts as empty.
std::size_t dispatch_index(std::string_view name);

}  // namespace hsr::lanes
