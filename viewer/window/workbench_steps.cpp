// What the workbench computes about single pixels and single steps.

#include "window/workbench.h"

namespace hsr::window {

TraceKey Workbench::trace_key() const {
  TraceKey key = {picture_key(), state.steps_of};
  if (key.of == StepsOf::pixel && state.pixel) key.pixel = *state.pixel;
  if (key.of == StepsOf::face) key.face = selected_face();
  if ((key.of == StepsOf::pixel && !state.pixel) || (key.of == StepsOf::face && key.face == background_id)) {
    key.of = StepsOf::all;
  }
  return key;
}

MomentKey Workbench::moment_key() const {
  return {trace_key(), state.step, state.pixel.value_or(glm::ivec2(-1)), state.theme};
}

MarksKey Workbench::marks_key() const {
  return {trace_key(), state.pixel.value_or(glm::ivec2(-1)), selected_face(), truth() != nullptr};
}

std::uint32_t Workbench::selected_face() const {
  if (!state.pixel || !picture_is_current()) return background_id;
  const Frame& frame = picture()->frame;
  if (state.pixel->x >= frame.width || state.pixel->y >= frame.height) return background_id;
  const std::uint32_t id = frame.id[frame.index(state.pixel->x, state.pixel->y)];
  return id == background_id ? background_id : model()->scene->triangles[id].face;
}

void Workbench::want_steps() {
  if (!picture_is_current() || settling_) return;
  const Extent size = picture_size();
  // Without a pixel, what every pixel needs is prepared, so that the first one is told as soon as the others.
  const bool there = story_pixel_ && story_pixel_->x < size.width && story_pixel_->y < size.height;
  const StoryKey key = {picture_key(), there ? *story_pixel_ : glm::ivec2(-1)};
  if (there || !story_lane_.result_key() || !(story_lane_.result_key()->picture == key.picture)) {
    story_lane_.want(key, true, [&] {
      const Frame& frame = picture()->frame;
      const std::uint32_t shown = there && frame.width == size.width
                                      ? frame.id[frame.index(key.pixel.x, key.pixel.y)]
                                      : background_id;
      return [key, shown, given = surroundings(), keeper = story_keeper_](const Progress& progress) {
        return tell_story(key, shown, given, *keeper, progress);
      };
    });
  }
  if (!state.stepping) return;
  trace_lane_.want(trace_key(), true, [&] {
    return [key = trace_key(), given = surroundings()](const Progress& progress) {
      return make_trace(key, given, progress);
    };
  });
  const auto steps = trace();
  if (!steps) return;
  state.step = std::min(state.step, steps->total);
  moment_lane_.want(moment_key(), false, [&] {
    return [key = moment_key(), steps, given = surroundings()](const Progress& progress) {
      return find_moment(key, *steps, given.backdrop, progress);
    };
  });
  marks_lane_.want(marks_key(), false, [&] {
    return [key = marks_key(), steps, exact = truth()](const Progress& progress) {
      return find_marks(key, *steps, exact, progress);
    };
  });
}

std::shared_ptr<const Story> Workbench::story() const {
  if (!story_pixel_ || !picture_is_current() || !story_lane_.result()) return nullptr;
  if (!(*story_lane_.result_key() == StoryKey{picture_key(), *story_pixel_})) return nullptr;
  return story_lane_.result();
}

std::shared_ptr<const Trace> Workbench::trace() const {
  if (!picture_is_current() || !trace_lane_.result() || !(*trace_lane_.result_key() == trace_key()))
    return nullptr;
  return trace_lane_.result();
}

std::shared_ptr<const Moment> Workbench::moment() const {
  if (!trace() || !moment_lane_.result() || !(moment_lane_.result_key()->trace == trace_key()))
    return nullptr;
  return moment_lane_.result();
}

std::shared_ptr<const Marks> Workbench::marks() const {
  if (!trace() || !marks_lane_.result() || !(*marks_lane_.result_key() == marks_key())) return nullptr;
  return marks_lane_.result();
}

}  // namespace hsr::window
