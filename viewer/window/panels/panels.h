#pragma once

#include "window/layout.h"
#include "window/session.h"
#include "window/ui.h"

namespace hsr::window {

// One function a panel, each in a file of its own. They draw what is and change what is asked to be
// changed; nothing is computed here that takes long.

/// Along the top: scene, algorithms, modes.
void draw_bar(Ui& ui, Session& session, const Area& area);
/// The scene picker and the scene's parameters.
void draw_scene_panel(Ui& ui, Session& session);
/// The algorithm's idea and settings.
void draw_algorithm_panel(Ui& ui, Session& session);
/// Skips with their counts, times, memory.
void draw_work_panel(Ui& ui, Session& session);
/// What the picture is compared with, and overlays.
void draw_compare_panel(Ui& ui, Session& session);
/// The picture itself, and what the mouse does there.
void draw_picture(Ui& ui, Session& session, const Area& area);
/// Everything about one pixel.
void draw_pixel_panel(Ui& ui, Session& session, const Area& area);
/// The time line, its buttons, and the present step in words.
void draw_steps_panel(Ui& ui, Session& session, const Area& area);
/// Along the bottom: work that is going on, errors.
void draw_status(Ui& ui, Session& session, const Area& area);
/// The text of the lesson's step, and the way to the next.
void draw_lesson_panel(Ui& ui, Session& session, const Area& area);
/// The list of lessons over everything.
void draw_lesson_list(Ui& ui, Session& session);
/// The list of keys over everything.
void draw_key_card(Ui& ui, Session& session);

}  // namespace hsr::window
