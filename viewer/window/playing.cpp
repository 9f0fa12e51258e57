#include "window/playing.h"

#include <algorithm>
#include <cmath>

namespace hsr::window {
namespace {

std::uint64_t last_step(const Session& session) {
  const auto trace = session.bench.trace();
  return trace ? trace->total : session.bench.state.step;
}

const std::vector<std::uint64_t>& marks_of(const Marks& marks, MarkKind kind) {
  if (kind == MarkKind::pixel) return marks.pixel;
  return kind == MarkKind::face ? marks.face : marks.turns;
}

const char* name_of(MarkKind kind) {
  if (kind == MarkKind::pixel) return "step of this pixel";
  return kind == MarkKind::face ? "step of this face" : "exchange, cycle, crossing or split";
}

}  // namespace

void toggle_stepping(Session& session) {
  session.bench.state.stepping = !session.bench.state.stepping;
  session.playing = false;
}

void toggle_playing(Session& session) {
  State& state = session.bench.state;
  session.playing = !session.playing;
  if (session.playing && state.stepping && state.step >= last_step(session)) state.step = 0;
  state.stepping = true;
  session.step_rest = 0.0;
}

void go_to_step(Session& session, std::uint64_t step) {
  session.bench.state.stepping = true;
  session.bench.state.step = std::min(step, last_step(session));
}

void step_by(Session& session, std::int64_t steps) {
  session.playing = false;
  const auto now = static_cast<std::int64_t>(session.bench.state.step);
  go_to_step(session, static_cast<std::uint64_t>(std::max<std::int64_t>(now + steps, 0)));
}

void go_to_mark(Session& session, MarkKind kind, int direction) {
  session.bench.state.stepping = true;
  session.playing = false;
  const auto marks = session.bench.marks();
  if (!marks) return session.tell("the steps are not counted yet");
  if (kind != MarkKind::turn && !session.bench.state.pixel) return session.tell("select a pixel first");
  const std::vector<std::uint64_t>& steps = marks_of(*marks, kind);
  const std::uint64_t now = session.bench.state.step;
  if (direction > 0) {
    const auto next = std::ranges::upper_bound(steps, now);
    if (next != steps.end()) return go_to_step(session, *next);
  } else {
    const auto after = std::ranges::lower_bound(steps, now);
    if (after != steps.begin()) return go_to_step(session, *std::prev(after));
  }
  session.tell(std::string("no ") + (direction > 0 ? "further " : "earlier ") + name_of(kind));
}

void go_to_departure(Session& session) {
  session.bench.state.stepping = true;
  session.playing = false;
  const auto marks = session.bench.marks();
  if (!marks || !session.bench.truth()) return session.tell("the steps are not checked yet");
  if (!marks->departure) return session.tell("no step departs from the exact answer for good");
  go_to_step(session, *marks->departure);
}

void play(Session& session, double seconds) {
  State& state = session.bench.state;
  if (!session.playing || !session.bench.trace()) return;
  session.step_rest += seconds * static_cast<double>(state.speed);
  const double whole = std::floor(session.step_rest);
  session.step_rest -= whole;
  state.step = std::min(state.step + static_cast<std::uint64_t>(whole), last_step(session));
  if (state.step >= last_step(session)) session.playing = false;
}

}  // namespace hsr::window
