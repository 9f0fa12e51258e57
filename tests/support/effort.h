#pragma once

#include <cstdint>

namespace hsr::test {

// GCC says so by macros, clang by features.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HSR_SANITIZED true
#elif defined(__has_feature)
#define HSR_SANITIZED (__has_feature(address_sanitizer) || __has_feature(thread_sanitizer))
#else
#define HSR_SANITIZED false
#endif

/// Whether a sanitizer watches, which makes everything five to twenty times slower.
inline constexpr bool sanitized = HSR_SANITIZED;
#undef HSR_SANITIZED

/// How many of so many random cases to try: all, or under a sanitizer, which looks for other mistakes
/// than wrong results, every tenth.
constexpr std::uint64_t cases(std::uint64_t all) { return sanitized ? (all + 9) / 10 : all; }

}  // namespace hsr::test
