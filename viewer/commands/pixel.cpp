#include <ostream>

#include "commands/commands.h"
#include "failures/pixel_story.h"
#include "output_file.h"
#include "picture.h"
#include "pixel_text.h"
#include "skip_choice.h"

namespace hsr {

void run(const PixelCommand& command, std::ostream& out) {
  if (command.json) require_place(*command.json);
  ProgressBar bar;
  const LoadedScene loaded = load_scene(command.picture.scene, bar);
  const View view = choose_view(loaded.scene, command.picture);
  const RenderOptions options = {command.picture.threads,
                                 chosen_skips(command.picture.skips_off, {&command.algorithm, 1}),
                                 bar.listener()};
  const auto renderer =
      command.algorithm.algorithm->prepare(loaded.scene, command.algorithm.settings, options);
  const PixelStory story = tell_pixel(view, *renderer, options, command.pixel.i, command.pixel.j);
  bar.erase();
  if (command.json) write_json(story, view, command.algorithm, *command.json);
  out << to_text(story, view, command.algorithm);
  if (command.json) out << "\nWrote " << command.json->string() << ".\n";
}

}  // namespace hsr
