#pragma once

#include <SDL.h>

#include <span>

#include "window/session.h"

namespace hsr::window {

/// Something that a key does.
struct Action {
  const char* keys;     ///< as on the key card
  const char* meaning;  ///< as on the key card; null: named by the line before
  SDL_Keycode key;
  unsigned modifiers;  ///< of KMOD_SHIFT, KMOD_CTRL, KMOD_ALT
  void (*run)(Session&);
};

/// Keys that belong together.
struct ActionGroup {
  const char* title;
  std::span<const Action> actions;
};

std::span<const ActionGroup> action_groups();

/// Does what the key is for. Returns whether it is for anything.
bool run_action(Session& session, SDL_Keycode key, unsigned modifiers);

/// Selects the next wrong pixel (or the one before, with -1) in reading order, from the selected one on.
void go_to_failure(Session& session, int direction);
/// Shows the selected pixel so large that pixels can be counted, or the whole picture again.
void toggle_zoom(Session& session);

}  // namespace hsr::window
