#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>

#include "trace/event.h"

namespace hsr {

/// A step at which an algorithm leaves the exact answer at a pixel for good.
struct Departure {
  std::uint64_t step = 0;  ///< its number, as it was told
  Event event;
};

/// Finds the first departure: the first step at which, at some pixel, an admissible triangle is
/// overwritten, rejected or missed for an inadmissible one and never restored. Needs memory for the
/// pixels at which something happens.
class DepartureFinder {
 public:
  /// Whether triangle `id` is admissible at pixel (i, j): covers its centre, and nothing is nearer.
  using Admissible = std::function<bool(int i, int j, std::uint32_t id)>;

  explicit DepartureFinder(Admissible admissible) : admissible_(std::move(admissible)) {}

  /// To be told every step of a run in order, with a number of the caller's choice; a departure at a
  /// step with the number 0 is not reported.
  void tell(const Event& event, std::uint64_t step);

  /// The first departure of the run that has been told; nothing if there is none.
  std::optional<Departure> first() const;

 private:
  struct Pixel {
    std::uint32_t shown = background_id;
    std::optional<Departure> lost = {};  // where an admissible triangle was lost, if none came after
  };

  void show(Pixel& pixel, const Event& event, std::uint64_t step);
  bool admissible(const Event& event, std::uint32_t id) const {
    return id != background_id && admissible_(event.i, event.j, id);
  }

  Admissible admissible_;
  std::unordered_map<std::uint64_t, Pixel> pixels_;
};

}  // namespace hsr
