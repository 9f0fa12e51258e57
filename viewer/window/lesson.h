#pragma once

#include "window/session.h"

namespace hsr::window {

// What a reader does with a lesson. Which one is open, and its step, are part of the state.

/// The lesson that is open; null if none is.
const OpenLesson* lesson_of(Session& session);
/// How many steps lesson `number` has. Throws InputError if its text is wrong.
int lesson_steps(Session& session, int number);

/// Opens lesson `number` (from 1) and shows its step `step`; one beyond the last is the last.
void open_lesson(Session& session, int number, int step);
void close_lesson(Session& session);
/// To the next step, or with -1 the one before; after the last step, to the next lesson.
void go_on(Session& session, int direction);
/// Sets scene, camera, algorithm, settings, pixel, overlay and trace step as the open step's script does.
void show_lesson_step(Session& session);
/// Whether what is shown is what the step sets.
bool shows_lesson_step(Session& session);

}  // namespace hsr::window
