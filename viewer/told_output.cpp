#include "told_output.h"

#include <array>
#include <fstream>

#include "nearest_name.h"
#include "scene/atomic_file.h"
#include "scene/errors.h"
#include "text_layout.h"

namespace hsr {

TellChoice parse_tell_choice(std::string_view option, std::string_view text) {
  static constexpr std::array<std::string_view, 2> parts = {"lists", "steps"};
  TellChoice choice;
  while (true) {
    const std::string_view part = text.substr(0, text.find(','));
    if (part == parts[0]) {
      choice.lists = true;
    } else if (part == parts[1]) {
      choice.steps = true;
    } else {
      throw UsageError(std::string(option) + ": unknown part \"" + std::string(part) + "\"" +
                       what_there_is(part, parts));
    }
    if (part.size() == text.size()) return choice;
    text.remove_prefix(part.size() + 1);
  }
}

ToldPicture tell_picture(const View& view, const AlgorithmSpec& algorithm, Renderer& renderer,
                         const RenderOptions& options, const Frame& frame, TellChoice tell) {
  ToldPicture picture;
  picture.view = ToldView{view.camera, view.near_depth, view.far_depth};
  if (tell.lists) {
    if (!algorithm.algorithm->traits.keeps_lists)
      throw UsageError("--tell: " + std::string(algorithm.algorithm->name) + " keeps no lists");
    picture.frame = Frame(view.width, view.height);
    picture.frame.lists.emplace();
    (void)renderer.render(view, options, picture.frame);
  } else {
    picture.frame = frame;
  }
  if (!tell.steps) return picture;
  picture.tells_steps = true;
  const std::size_t most = PictureLimits().steps;
  bool too_many = false;
  Frame traced(view.width, view.height);
  (void)renderer.trace(
      view, options,
      [&](const Event& event) {
        too_many |= picture.steps.size() == most;
        if (!too_many) picture.steps.push_back(event);
      },
      traced);
  if (too_many) {
    throw InputError("there are more than " + grouped(most) +
                     " steps, which is too many for a stream; a smaller picture has fewer");
  }
  return picture;
}

void write_told_picture(const ToldPicture& picture, const std::filesystem::path& file, std::ostream& out) {
  if (file == "-") {
    write_picture_stream(picture, out);
    out.flush();
    if (!out) throw InputError("the picture cannot be written to standard output");
    return;
  }
  write_file_atomically(file, [&](const std::filesystem::path& temporary) {
    std::ofstream stream(temporary, std::ios::binary);
    write_picture_stream(picture, stream);
    stream.close();
    if (!stream) throw InputError(temporary.string() + ": cannot be written");
  });
}

}  // namespace hsr
