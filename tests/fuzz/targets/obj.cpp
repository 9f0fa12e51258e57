#include "fuzz/support/run_reader.h"
#include "fuzz/targets.h"
#include "scene/readers/readers.h"
#include "support/temporary_folder.h"

namespace hsr::fuzz {

// Text has no NUL, so the first one parts the OBJ file from the MTL file beside it, which is called
// "m.mtl".
void obj(std::string_view bytes) {
  static const test::TemporaryFolder folder;
  const std::size_t nul = bytes.find('\0');
  if (nul != std::string_view::npos) {
    folder.write("m.mtl", bytes.substr(nul + 1));
  }
  run_reader(read_obj, folder / "fuzz.obj", bytes.substr(0, nul));
}

}  // namespace hsr::fuzz
