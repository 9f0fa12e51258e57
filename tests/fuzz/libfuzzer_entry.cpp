// What libFuzzer calls, compiled once for each target: HSR_FUZZ_TARGET is the target's name.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hsr::fuzz::HSR_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
