#include <ostream>

#include "commands/commands.h"
#include "output_file.h"
#include "picture.h"
#include "scene/write_scene.h"
#include "text_layout.h"

namespace hsr {

void run(const ExportCommand& command, std::ostream& out) {
  require_place(command.output);
  ProgressBar bar;
  const LoadedScene loaded = load_scene(command.scene, bar);
  write_scene(loaded.scene, command.output, bar.listener());
  bar.erase();
  out << loaded.scene.name << ": " << counted(loaded.scene.triangles.size(), "triangle") << "; wrote "
      << command.output.string() << "\n";
}

}  // namespace hsr
