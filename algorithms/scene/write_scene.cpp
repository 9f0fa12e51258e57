#include "scene/write_scene.h"

#include "scene/errors.h"
#include "scene/readers/messages.h"
#include "scene/writers/writers.h"

namespace hsr {

void write_scene(const Scene& scene, const std::filesystem::path& file, const Progress& progress) {
  const std::string ending = lower_case(file.extension().string());
  if (ending == ".obj") {
    write_obj(scene, file, progress);
  } else if (ending == ".ply") {
    write_ply(scene, file, progress);
  } else {
    throw InputError("cannot write " + file.string() + ": the ending must be .obj or .ply");
  }
}

}  // namespace hsr
