#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <unordered_map>
#include <vector>

#include "frame/frame.h"
#include "trace/event.h"

namespace hsr {

/// What a picture looks like while an algorithm's steps are made: id, depth and colour of every pixel,
/// and the fragments that its list holds so far. Steps can be taken back, the last one first.
class PictureState {
 public:
  /// An empty picture. `colors` are those of the triangles, premultiplied, by id (surface_colors), and
  /// must outlive the state.
  PictureState(int width, int height, const std::vector<glm::vec4>& colors);

  /// What a step changed, as it was before.
  struct Before {
    std::size_t pixel = 0;
    std::uint32_t id = background_id;
    float depth = 0.0F;
    glm::vec4 color{0.0F};
    glm::vec4 below{0.0F};
    enum class Change : std::uint8_t { nothing, picture, stored, list } change = Change::nothing;
    std::vector<ListFragment> list = {};  ///< where the whole list changed
  };

  /// Makes a step and tells what take_back needs.
  Before apply(const Event& event);
  /// Takes back the step that was made last of those not taken back.
  void take_back(Before before);

  const Frame& frame() const { return frame_; }
  /// The fragments that pixel (i, j) holds: as they came, and once the list is sorted by their float
  /// depths, ties by id. Empty where it has none.
  const std::vector<ListFragment>& list(int i, int j) const;
  /// Whether every fragment is in the lists; in all they hold at most most_list_fragments.
  bool lists_are_whole() const { return fragments_left_out_ == 0; }

  static constexpr std::size_t most_list_fragments = 4'000'000;

 private:
  Before change_picture(const Event& event);
  Before paint(const Event& event);
  Before store_fragment(const Event& event);
  Before sort_list(const Event& event);
  Before take_fragment(const Event& event);
  void show(const Event& event);
  std::size_t pixel_of(const Event& event) const { return frame_.index(event.i, event.j); }
  Before before(const Event& event) const;

  const std::vector<glm::vec4>* colors_;
  Frame frame_;
  std::vector<glm::vec4> below_;                                      // per pixel, what was painted over last
  std::unordered_map<std::size_t, std::vector<ListFragment>> lists_;  // by pixel
  std::size_t fragments_ = 0;
  std::size_t fragments_left_out_ = 0;
};

}  // namespace hsr
