#include "exact/errors.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

#include "exact/worker.h"

namespace hsr::exact {

namespace {

// Whether the triangle shown at a covered pixel is one of the nearest.
bool admissible(std::uint32_t shown, std::uint32_t nearest, int i, int j, Worker& exact) {
  if (shown == nearest) return true;
  return exact.covers(shown, i, j) && exact.compare_depth(shown, nearest, i, j) == 0;
}

std::optional<Errors::Depth> depth_errors(std::vector<double>& relative) {
  if (relative.empty()) return std::nullopt;
  // NaN would not sort; a depth that is no number is as wrong as can be.
  for (double& error : relative) {
    if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
  }
  const std::size_t place = (relative.size() * 99 + 99) / 100 - 1;
  const auto at_99 = relative.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(relative.begin(), at_99, relative.end());
  const double p99 = *at_99;
  return Errors::Depth{*std::ranges::max_element(relative), p99};
}

std::optional<Errors::Color> color_errors(const Frame& frame, const Nearest& nearest,
                                          const std::vector<glm::vec4>& colors) {
  double squares = 0.0;
  double greatest = 0.0;
  std::uint64_t compared = 0;
  for (std::size_t pixel = 0; pixel < colors.size(); ++pixel) {
    const bool nothing = nearest.id[pixel] == background_id && frame.id[pixel] == background_id;
    if (nothing && colors[pixel].a == 0.0F && frame.color[pixel].a == 0.0F) continue;
    ++compared;
    for (int channel = 0; channel < 3; ++channel) {
      const double difference = double{frame.color[pixel][channel]} - double{colors[pixel][channel]};
      squares += difference * difference;
      greatest = std::max(greatest, std::abs(difference));
    }
  }
  if (compared == 0) return std::nullopt;
  return Errors::Color{std::sqrt(squares / (3.0 * static_cast<double>(compared))), greatest};
}

}  // namespace

Errors measure_errors(const Frame& frame, const ExactAnswer& exact, const Nearest& nearest,
                      const std::vector<glm::vec4>& colors) {
  assert(frame.pixel_count() == nearest.id.size());
  Errors errors;
  Worker worker = exact.worker();
  std::vector<double> relative_depth;
  relative_depth.reserve(frame.pixel_count());
  for (int j = 0; j < frame.height; ++j) {
    for (int i = 0; i < frame.width; ++i) {
      const std::size_t pixel = frame.index(i, j);
      const std::uint32_t shown = frame.id[pixel];
      const std::uint32_t wanted = nearest.id[pixel];
      if (wanted == background_id) {
        errors.leaks += shown == background_id ? 0 : 1;
      } else if (shown == background_id) {
        ++errors.holes;
      } else if (!admissible(shown, wanted, i, j, worker)) {
        ++errors.wrong;
      } else {
        errors.other_of_tie += shown == wanted ? 0 : 1;
        relative_depth.push_back(std::abs(double{frame.depth[pixel]} - nearest.depth[pixel]) /
                                 nearest.depth[pixel]);
      }
    }
  }
  errors.depth = depth_errors(relative_depth);
  errors.color = color_errors(frame, nearest, colors);
  return errors;
}

}  // namespace hsr::exact
