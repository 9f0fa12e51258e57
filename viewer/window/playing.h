#pragma once

#include "window/session.h"

namespace hsr::window {

// What is done with steps, by keys and by buttons. Each begins to show steps if none are shown.

void toggle_stepping(Session& session);
void toggle_playing(Session& session);
/// One step forward or back.
void step_by(Session& session, std::int64_t steps);
void go_to_step(Session& session, std::uint64_t step);

/// Steps worth going to.
enum class MarkKind : std::uint8_t { pixel, face, turn };
/// To the next mark of a kind after the present step, or the one before.
void go_to_mark(Session& session, MarkKind kind, int direction);
void go_to_departure(Session& session);

/// Moves on by what `seconds` of playing are worth.
void play(Session& session, double seconds);

}  // namespace hsr::window
