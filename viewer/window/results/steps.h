#pragma once

#include <filesystem>
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
  std::shared_ptr<Progress> player_progress;  ///< asked while the player makes its run
  std::uint64_t total = 0;
  std::vector<Event> order;  ///< the steps that give triangles their places in an order, those in front
};

Trace make_trace(const TraceKey& key, const Surroundings& given, const Progress& progress);

/// The picture after so many steps.
struct MomentKey {
  TraceKey trace;
  std::uint64_t step = 0;
  glm::ivec2 pixel{-1};  ///< whose list is wanted
  Theme theme = Theme::dark;
  bool operator==(const MomentKey&) const = default;
};

struct Moment {
  std::uint64_t step = 0;
  ScreenPicture screen;        ///< the picture after that step
  std::optional<Event> event;  ///< the step that was made last
  std::string sentence;        ///< in words
  std::vector<ListFragment>
      list;                    ///< what the list holds so far: of the step's pixel, else of that asked for
  std::vector<Event> visited;  ///< nodes and cells that the step's ray came to, up to now
  std::vector<Event> order;    ///< the places about that of the step's triangle, by place
  double milliseconds = 0.0;   ///< that finding it took
};

Moment find_moment(const MomentKey& key, const Trace& trace, const glm::vec3& backdrop,
                   const Progress& progress);

/// Writes an animation of the picture while the steps are made. Throws InputError.
void write_gif_of(const Trace& trace, const std::filesystem::path& file, const Surroundings& given,
                  const Progress& progress);

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
Marks find_marks(const MarksKey& key, const Trace& trace, const std::shared_ptr<const Truth>& truth,
                 const Progress& progress);

}  // namespace hsr::window
