#pragma once

#include <cstdint>

namespace hsr::test {

/// Whether a sanitizer watches, which makes everything five to twenty times slower.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

/// How many of so many random cases to try: all, or under a sanitizer, which looks for other mistakes
/// than wrong results, every tenth.
constexpr std::uint64_t cases(std::uint64_t all) { return sanitized ? (all + 9) / 10 : all; }

}  // namespace hsr::test
