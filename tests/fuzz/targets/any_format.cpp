#include <array>

#include "fuzz/support/check_scene.h"
#include "fuzz/support/run_reader.h"
#include "fuzz/targets.h"
#include "scene/errors.h"
#include "scene/read_scene.h"
#include "support/temporary_folder.h"

namespace hsr::fuzz {

// The first byte chooses the ending of the file's name, the rest is the file: all that happens to a
// file between its name and its reader, unzipping included.
void any_format(std::string_view bytes) {
  if (bytes.empty()) return;
  constexpr std::array<std::string_view, 8> names = {"f",     "f.obj", "f.ply",  "f.off",
                                                     "f.stl", "f.glb", "f.gltf", "f.obj.gz"};
  static const test::TemporaryFolder folder;
  const std::size_t name = static_cast<unsigned char>(bytes.front()) % names.size();
  const std::filesystem::path file = folder.write(names[name], bytes.substr(1));
  ReadReport report;
  try {
    check_scene(read_scene(file, report));
  } catch (const InputError& error) {
    check_message(error.what());
  }
  for (const std::string& line : report.warnings) check_message(line);
}

}  // namespace hsr::fuzz
