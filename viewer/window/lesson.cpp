#include "window/lesson.h"

#include <algorithm>

#include "scene/errors.h"
#include "window/script/runner.h"
#include "window/state_text.h"

namespace hsr::window {
namespace {

/// Takes over what no step sets.
void keep(State& state, const State& now) {
  state.elsewhere = now.elsewhere;
  state.log_depth = now.log_depth;
  state.speed = now.speed;
  state.theme = now.theme;
  state.window = now.window;
  state.scale = now.scale;
  state.lecture = now.lecture;
  state.lesson = now.lesson;
  state.lesson_step = now.lesson_step;
  state.lesson_aside = now.lesson_aside;
}

/// What the open step sets; all else as it is now.
State step_state(const OpenLesson& lesson, const State& now) {
  State state;
  set_as_script(state, lesson.script_up_to(now.lesson_step), std::string(lesson.lesson->folder));
  keep(state, now);
  return state;
}

}  // namespace

const OpenLesson* lesson_of(Session& session) {
  const int number = session.bench.state.lesson;
  const auto lessons = lesson_catalog();
  if (number < 1 || number > static_cast<int>(lessons.size())) return nullptr;
  if (!session.lesson || session.lesson->number != number) {
    session.lesson = hsr::open_lesson(lessons[static_cast<std::size_t>(number - 1)]);
    session.lesson_state.reset();
  }
  int& step = session.bench.state.lesson_step;
  step = std::clamp(step, 1, static_cast<int>(session.lesson->steps.size()));
  return &*session.lesson;
}

int lesson_steps(Session& session, int number) {
  const Lesson& lesson = lesson_catalog()[static_cast<std::size_t>(number - 1)];
  const bool open = session.lesson && session.lesson->number == number;
  return static_cast<int>(open ? session.lesson->steps.size() : hsr::open_lesson(lesson).steps.size());
}

void open_lesson(Session& session, int number, int step) {
  session.bench.state.lesson = number;
  session.bench.state.lesson_step = step;
  session.bench.state.lesson_aside = false;
  show_lesson_step(session);
}

void close_lesson(Session& session) {
  session.bench.state.lesson = 0;
  session.bench.state.picture.reset();  // steps set its size; without one it fits its place
}

void go_on(Session& session, int direction) {
  const OpenLesson* lesson = lesson_of(session);
  if (lesson == nullptr) return session.tell("no lesson is open: H shows the list");
  State& state = session.bench.state;
  const int step = state.lesson_step + direction;
  if (step > static_cast<int>(lesson->steps.size())) {
    if (state.lesson < static_cast<int>(lesson_catalog().size()))
      return open_lesson(session, state.lesson + 1, 1);
    return session.tell("this is the end of the last lesson");
  }
  if (step >= 1) open_lesson(session, state.lesson, step);
}

void show_lesson_step(Session& session) {
  const OpenLesson* lesson = lesson_of(session);
  if (lesson == nullptr) return;
  session.playing = false;
  session.moving_parameter = -1;
  session.bench.state = step_state(*lesson, session.bench.state);
}

bool shows_lesson_step(Session& session) {
  const OpenLesson* lesson = lesson_of(session);
  if (lesson == nullptr) return true;
  const State& now = session.bench.state;
  const std::pair<int, int> place = {now.lesson, now.lesson_step};
  if (!session.lesson_state || session.lesson_place != place) {
    session.lesson_state = step_state(*lesson, now);
    session.lesson_place = place;
  }
  State wanted = *session.lesson_state;
  keep(wanted, now);
  return state_text(wanted) == state_text(now);
}

}  // namespace hsr::window
