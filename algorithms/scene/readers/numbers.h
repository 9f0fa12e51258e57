#pragma once

#include <cstdint>

namespace hsr {

/// Reads a decimal number at the start of [at, end) into `value`, rounded correctly to float32
/// once: "1", "-.8e-001", "+5.", also "nan" and "inf". What is too small becomes a zero or a
/// denormal number, what is too large an infinity. Returns where the number ends, or null if there
/// is none; the caller checks what follows.
const char* parse_decimal(const char* at, const char* end, float& value);

/// Reads a whole number with an optional sign at the start of [at, end) into `value`. What does not
/// fit 18 digits becomes ±10^18. Returns where the number ends, or null if there is none.
const char* parse_whole(const char* at, const char* end, std::int64_t& value);

/// `value` rounded to float32; what is too large becomes an infinity.
float round_to_float(double value);

}  // namespace hsr
