#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

#include "algorithm.h"

namespace hsr {

/// Makes the renderer of an algorithm that is in no catalogue.
using RendererMaker = std::function<std::unique_ptr<Renderer>()>;

/// A pixel that shows `shown` where `nearest` is the nearest.
struct WrongPixel {
  int i = 0;
  int j = 0;
  std::uint32_t shown = background_id;
  std::uint32_t nearest = background_id;
};

/// What the algorithm's own steps say about a wrong pixel.
struct Evidence {
  bool met_nearest = false;      ///< the nearest triangle was found to cover the pixel
  bool compared_depths = false;  ///< depths were compared there to decide what is seen
  bool list_was_full = false;    ///< the nearest fragment was dropped for want of room
};

/// The evidence for each wrong pixel, and the sort keys that the algorithm gave triangles.
struct AllEvidence {
  bool heard = false;                              ///< whether it told any step
  std::vector<Evidence> pixels;                    ///< as the wrong pixels
  std::unordered_map<std::uint32_t, double> keys;  ///< by id
};

/// Lets the algorithm run once more over the rectangle that holds the wrong pixels, and listens.
/// `maker`, if given, makes its renderer.
AllEvidence gather_evidence(const View& view, const AlgorithmSpec& spec, const RenderOptions& options,
                            const std::vector<WrongPixel>& wrong, const RendererMaker& maker);

}  // namespace hsr
