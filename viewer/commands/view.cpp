#include <SDL.h>

#include <iostream>

#include "commands/commands.h"
#include "scene/errors.h"
#include "window/app.h"
#include "window/lesson.h"
#include "window/script/runner.h"
#include "window/state_text.h"

namespace hsr {
namespace {

using window::State;

/// Where the state is kept from one run to the next; empty if the system names no place for such things.
std::filesystem::path kept_state_file() {
  char* folder = SDL_GetPrefPath("hidden-surface-kit", "hsr");
  if (folder == nullptr) return {};
  const std::filesystem::path file = std::filesystem::path(folder) / "last.hsr";
  SDL_free(folder);
  return file;
}

/// What one left; nothing on the first run. A state that cannot be read any more is passed over with a word.
std::optional<State> kept_state(const std::filesystem::path& file) {
  std::error_code ignored;
  if (file.empty() || !std::filesystem::exists(file, ignored)) return std::nullopt;
  try {
    return window::read_state_file(file);
  } catch (const InputError& error) {
    std::cerr << "warning: " << error.what() << "; beginning anew\n";
    return State{};
  }
}

bool is_state_file(const std::string& name) { return name.ends_with(".hsr"); }

/// The state that the command line asks for, on top of what one left.
State chosen_state(const ViewCommand& command, const State& left) {
  if (is_state_file(command.scene)) {
    State state = window::read_state_file(command.scene);
    if (command.algorithm) state.algorithm = *command.algorithm;
    return state;
  }
  State state = left;
  if (!command.scene.empty() && command.scene != left.scene) {
    state.scene = command.scene;
    state.moved.clear();
    state.camera.reset();
    state.pixel.reset();
    if (state.lesson != 0) state.picture.reset();
    state.lesson = 0;
  }
  if (command.algorithm) {
    state.algorithm = *command.algorithm;
    state.skips_off.clear();
  }
  return state;
}

/// Hands the app the state, and what is asked of pictures that are not made here.
void begin(window::App& app, const ViewCommand& command, const State& state) {
  window::Workbench& bench = app.session().bench;
  bench.state = state;
  bench.limits = command.limits;
  bench.watched = command.watched;
  using window::Elsewhere;
  if (command.picture_file) bench.show_from({Elsewhere::Kind::file, *command.picture_file});
  if (command.picture_command) bench.show_from({Elsewhere::Kind::command, *command.picture_command, true});
}

}  // namespace

void run(const ViewCommand& command, std::ostream& out) {
  constexpr window::Extent size = {1280, 720};
  if (command.script) {
    const State state = chosen_state(command, {});
    window::App app(size, true, command.threads);
    begin(app, command, state);
    window::run_script(app, *command.script, out);
    return;
  }
  const std::filesystem::path kept = kept_state_file();
  const std::optional<State> left = kept_state(kept);
  const State state = chosen_state(command, left.value_or(State{}));
  window::App app(state.window.value_or(size), false, command.threads);
  begin(app, command, state);
  if (command.lesson > 0) window::open_lesson(app.session(), command.lesson, command.lesson_step);
  app.session().key_card = !left && command.lesson == 0;
  app.run();
  if (!kept.empty()) window::write_state_file(app.session().bench.state, kept);
}

}  // namespace hsr
