#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "trace/player.h"
#include "window/results/rendered.h"
#include "window/results/truth.h"

namespace hsr::window {

/// Which run, and which of its steps.
struct TraceKey {
  PictureKey picture;
  StepsOf of = StepsOf::all;
  glm::ivec2 pixel{-1};                ///< for the steps of a pixel
  std::uint32_t face = background_id;  ///< for the steps of a face
  bool operator==(const TraceKey&) const = default;
};

/// A run that can be played. Players are moved in one lane only, so no two threads ever use one.
struct Trace {
  std::shared_ptr<const Scene> scene;
  View view;
  TracedRun run;  ///< only with the steps that are wanted; may be called from several threads
  std::shared_ptr<Player> player;
  std::uint64_t total = 0;
};

Trace make_trace(const TraceKey& key, const Surroundings& given, const Progress& progress);

/// The picture after so many steps.
struct MomentKey {
  TraceKey trace;
  std::uint64_t step = 0;
  glm::ivec2 pixel{-1};  ///< whose list is wanted
  bool operator==(const MomentKey&) const = default;
};

struct Moment {
  std::uint64_t step = 0;
  Frame frame;
  std::optional<Event> event;      ///< the step that was made last
  std::string sentence;            ///< in words
  std::vector<ListFragment> list;  ///< what the pixel's list holds so far
};

Moment find_moment(const MomentKey& key, const Trace& trace);

/// Steps worth going to.
struct MarksKey {
  TraceKey trace;
  glm::ivec2 pixel{-1};
  std::uint32_t face = background_id;
  bool with_truth = false;
  bool operator==(const MarksKey&) const = default;
};

struct Marks {
  std::vector<std::uint64_t> pixel;        ///< at the selected pixel
  std::vector<std::uint64_t> face;         ///< about the selected pixel's face
  std::vector<std::uint64_t> turns;        ///< exchanges, cycles, crossings, splits
  std::optional<std::uint64_t> departure;  ///< where the exact answer is left first
};

/// `truth` may be null; then the departure is not looked for.
Marks find_marks(const MarksKey& key, const Trace& trace, const std::shared_ptr<const Truth>& truth);

}  // namespace hsr::window
