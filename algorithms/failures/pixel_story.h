#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "algorithm.h"
#include "exact/exact_answer.h"
#include "failures/first_departure.h"
#include "trace/recording.h"
#include "view/view.h"

namespace hsr {

/// All that can be said about one pixel's centre: what lies behind it, and what an algorithm did there.
struct PixelStory {
  int i = 0;
  int j = 0;
  std::vector<exact::Fragment> list;  ///< everything that covers it, nearest first, exactly
  glm::vec4 exact_color{0.0F};        ///< of that list, front to back, linear and premultiplied

  /// The algorithm's steps at the pixel, and those about no pixel whose triangles occur there.
  Recording history;
  std::uint32_t id = background_id;  ///< its answer
  float depth = 0.0F;
  glm::vec4 color{0.0F};
  std::optional<Departure> departure;  ///< the step of `history` at which it left the exact answer

  bool covered() const { return !list.empty(); }
  /// Whether `shown` is one of the nearest.
  bool admissible(std::uint32_t shown) const;
  /// The fragment of triangle `shown`; null if it does not cover the centre.
  const exact::Fragment* fragment_of(std::uint32_t shown) const;
};

/// Tells pixels of one picture, one after the other. The algorithm runs once for a square of pixels, and what
/// it did there is kept: the next pixel of the same square is told at once. For one thread at a time.
class PixelTeller {
 public:
  /// By an algorithm that is prepared for the view's scene; scene and renderer must outlive this. The
  /// options' window and progress function are not used. Squares are `side` pixels wide and high, side by
  /// side from the upper left corner.
  PixelTeller(const View& view, Renderer& renderer, const RenderOptions& options, int side);

  /// The story of a pixel, which must be in the picture. Unfinished if `progress` asks to stop.
  PixelStory tell(int i, int j, const Progress& progress);

 private:
  void trace_square(const PixelBox& square, const Progress& progress);

  View view_;
  Renderer& renderer_;
  RenderOptions options_;
  int side_;
  std::optional<PixelBox> square_;  ///< whose steps are kept
  std::vector<Event> steps_;        ///< at its pixels, and those about no pixel of triangles that occur there
  Frame frame_;                     ///< right within the square
};

/// Makes one pixel by an algorithm that is prepared for the view's scene, and gathers its story. The
/// pixel must be in the picture. The options' window is not used.
PixelStory tell_pixel(const View& view, Renderer& renderer, const RenderOptions& options, int i, int j);

/// Of each fragment of the list, whether the triangle's front is seen: its corners run counterclockwise
/// as seen from the eye.
std::vector<bool> fronts(const View& view, const std::vector<exact::Fragment>& list);

/// One sentence, with a full stop, that explains the pixel's colour: why this triangle is shown, or
/// what is wrong and why.
std::string explanation(const View& view, const AlgorithmSpec& algorithm, const PixelStory& story);

}  // namespace hsr
