#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "frame/fragment_lists.h"
#include "frame/painted_faces.h"
#include "scene/scene.h"

namespace hsr {

/// A picture: colour, eye depth and primitive id of every pixel, row by row from the top left.
struct Frame {
  Frame() = default;
  Frame(int frame_width, int frame_height)
      : width(frame_width),
        height(frame_height),
        color(pixel_count(), glm::vec4(0.0F)),
        depth(pixel_count(), std::numeric_limits<float>::infinity()),
        id(pixel_count(), background_id) {}

  /// A frame for ids and depths alone, without colours. Only fast versions can fill it.
  static Frame without_colors(int frame_width, int frame_height) {
    Frame frame;
    frame.width = frame_width;
    frame.height = frame_height;
    frame.depth.assign(frame.pixel_count(), std::numeric_limits<float>::infinity());
    frame.id.assign(frame.pixel_count(), background_id);
    return frame;
  }

  std::size_t pixel_count() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i);
  }

  int width = 0;
  int height = 0;
  /// Linear RGB times opacity, and opacity; background all zero. Empty where ids and depths are all that
  /// is wanted.
  std::vector<glm::vec4> color;
  std::vector<float> depth;       ///< eye depth in scene units; background +infinity
  std::vector<std::uint32_t> id;  ///< primitive id; background_id where nothing is shown
  /// Set by whoever wants them, and filled by algorithms that keep every fragment; else left empty.
  std::optional<FragmentLists> lists;
  /// Set by whoever wants them, and filled by algorithms that paint whole faces: in paint order.
  std::optional<std::vector<PaintedFace>> faces;
};

}  // namespace hsr
