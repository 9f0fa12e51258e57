#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "failures/pixel_story.h"
#include "window/results/rendered.h"

namespace hsr::window {

/// Which pixel of which picture.
struct StoryKey {
  PictureKey picture;
  glm::ivec2 pixel{0};  ///< (-1, -1): only prepare the story of any pixel
  bool operator==(const StoryKey&) const = default;
};

/// One step at the pixel, in words.
struct HistoryLine {
  std::string sentence;
  bool decided = false;  ///< whether something was passed or failed
  bool passed = false;
  bool departure = false;  ///< here the algorithm left the exact answer
};

/// A pixel's story with all that its panel shows.
struct Story {
  std::shared_ptr<const Scene> scene;
  View view;
  PixelStory pixel;
  std::string explanation;               ///< one sentence
  std::vector<bool> fronts;              ///< of each fragment of the list: its front is seen
  std::vector<glm::vec4> colors;         ///< of each fragment, premultiplied
  std::vector<glm::vec4> so_far;         ///< colour with all fragments up to this one
  std::vector<std::uint32_t> own_order;  ///< places in the list, in the order in which the algorithm met them
  bool painted = false;                  ///< that order is one of painting: what comes later covers
  std::vector<HistoryLine> history;      ///< its first steps
  std::uint64_t history_total = 0;
  std::string text;  ///< all of it, as hsr pixel prints it
  double milliseconds = 0.0;
};

/// What is kept from one pixel of a picture to the next: the renderer, and the steps about the last one. For
/// one thread at a time.
class StoryKeeper {
 public:
  /// `shown` is the triangle that the picture shows at the pixel. Throws InputError when asked to stop.
  PixelStory tell(const StoryKey& key, std::uint32_t shown, const Surroundings& given,
                  const Progress& progress);
  /// Prepares what every pixel of the picture needs.
  void prepare(const PictureKey& picture, const Surroundings& given, const Progress& progress);

 private:
  PreparedRenderers prepared_;
  std::optional<PictureKey> picture_;
  std::unique_ptr<PixelTeller> teller_;  ///< of that picture
};

/// Tells the story of a pixel at which the picture shows triangle `shown`.
Story tell_story(const StoryKey& key, std::uint32_t shown, const Surroundings& given, StoryKeeper& keeper,
                 const Progress& progress);

}  // namespace hsr::window
