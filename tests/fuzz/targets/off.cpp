#include "fuzz/support/run_reader.h"
#include "fuzz/targets.h"
#include "scene/readers/readers.h"

namespace hsr::fuzz {

// The readers of text are given no NUL.
void off(std::string_view bytes) { run_reader(read_off, "fuzz.off", bytes.substr(0, bytes.find('\0'))); }

}  // namespace hsr::fuzz
