#include "fuzz/support/run_reader.h"
#include "fuzz/targets.h"
#include "scene/readers/readers.h"

namespace hsr::fuzz {

void ply(std::string_view bytes) { run_reader(read_ply, "fuzz.ply", bytes); }

}  // namespace hsr::fuzz
