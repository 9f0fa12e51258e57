#include "window/files.h"

#include <SDL.h>

#include <filesystem>

#include "frame/write_image.h"
#include "scene/atomic_file.h"
#include "scene/errors.h"
#include "text_layout.h"
#include "window/state_text.h"
#include "window/theme.h"

namespace hsr::window {
namespace {

/// Tells the name of what `write` wrote, or what went wrong.
template <class Write>
void save(Session& session, const std::string& name, const std::string& ending, Write write) {
  try {
    const std::filesystem::path file = free_name(name, ending);
    write(file);
    session.tell("wrote " + std::filesystem::absolute(file).string());
  } catch (const std::exception& error) {
    session.tell(error.what());
  }
}

}  // namespace

std::filesystem::path free_name(const std::string& name, const std::string& ending) {
  std::filesystem::path file;
  int number = 1;
  do {
    file = name + "-" + std::to_string(number++) + ending;
  } while (std::filesystem::exists(file));
  return file;
}

void save_state(Session& session) {
  save(session, "hsr", ".hsr",
       [&](const auto& file) { write_state_file(session.bench.exact_state(), file); });
}

void copy_state(Session& session) {
  SDL_SetClipboardText(state_text(session.bench.exact_state()).c_str());
  session.tell("the state is in the clipboard");
}

void paste_state(Session& session) {
  char* text = SDL_GetClipboardText();
  try {
    session.bench.state = read_state_text(text != nullptr ? text : "", "clipboard");
    session.tell("the state of the clipboard");
  } catch (const InputError& error) {
    session.tell(error.what());
  }
  SDL_free(text);
}

void save_picture(Session& session) {
  const auto picture = session.bench.picture();
  if (!picture) return session.tell("there is no picture yet");
  save(session, "picture", ".png", [&](const auto& file) {
    write_png(picture->frame, palette_of(session.bench.state.theme).backdrop, file);
  });
}

void save_window(Session& session, const SdlWindow& window) {
  save(session, "window", ".png",
       [&](const auto& file) { write_png(window.content(), glm::vec3(0.0F), file); });
}

void save_gif(Session& session) {
  if (!session.bench.trace()) return session.tell("there are no steps yet (P shows them)");
  session.bench.write_gif(free_name("steps", ".gif"));
}

void save_list(Session& session, const Story& story) {
  std::string table = "rank,triangle,face,depth,opacity,side,tied\n";
  for (std::size_t k = 0; k < story.pixel.list.size(); ++k) {
    const exact::Fragment& fragment = story.pixel.list[k];
    table += std::to_string(k) + "," + std::to_string(fragment.id) + "," +
             std::to_string(story.scene->triangles[fragment.id].face) + "," +
             significant(fragment.depth, 17) + "," + significant(story.colors[k].a, 9) + "," +
             (story.fronts[k] ? "front" : "back") + "," + (fragment.tied ? "yes" : "no") + "\n";
  }
  save(session, "list", ".csv", [&](const auto& file) {
    write_file_atomically(file,
                          [&](const std::filesystem::path& temporary) { write_bytes(temporary, table); });
  });
}

}  // namespace hsr::window
