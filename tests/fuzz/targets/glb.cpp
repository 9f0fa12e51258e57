#include "fuzz/support/run_reader.h"
#include "fuzz/targets.h"
#include "scene/readers/readers.h"

namespace hsr::fuzz {

// The file stands in a folder that does not exist, so that a uri finds no file of this machine by a
// relative path.
void glb(std::string_view bytes) { run_reader(read_glb, "no-such-folder/fuzz.glb", bytes); }

}  // namespace hsr::fuzz
