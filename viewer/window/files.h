#pragma once

#include <filesystem>
#include <string>

#include "window/results/story.h"
#include "window/session.h"

namespace hsr::window {

// What is kept in files of the current folder, under the first free name of its kind; the status line
// tells the name, or why there is no file.

/// The whole state: hsr-1.hsr.
void save_state(Session& session);
/// The state to the clipboard as text, and from there.
void copy_state(Session& session);
void paste_state(Session& session);
/// The picture alone, over the backdrop: picture-1.png.
void save_picture(Session& session);
/// The whole window as it was drawn: window-1.png.
void save_window(Session& session, const SdlWindow& window);
/// The steps as an animation, in the background: steps-1.gif.
void save_gif(Session& session);
/// A pixel's depth list: list-1.csv.
void save_list(Session& session, const Story& story);

/// The first name NAME-1ENDING, NAME-2ENDING ... of which there is no file yet.
std::filesystem::path free_name(const std::string& name, const std::string& ending);

}  // namespace hsr::window
