#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "predicates/pixel_box.h"
#include "scene/scene.h"
#include "trace/event.h"

namespace hsr {

/// Makes one run of an algorithm and tells each of its steps to the listener: the same each time.
using TracedRun = std::function<void(const EventListener&)>;

/// Primitive ids, in increasing order, each once.
class IdSet {
 public:
  IdSet() = default;
  explicit IdSet(std::vector<std::uint32_t> ids);
  bool contains(std::uint32_t id) const;
  std::size_t size() const { return ids_.size(); }

 private:
  std::vector<std::uint32_t> ids_;
};

/// Which steps of a run somebody wants to see.
struct EventFilter {
  /// If given, only steps at these pixels, and those about no pixel.
  std::optional<PixelBox> window = {};
  /// If given, only steps about one of these triangles.
  std::optional<IdSet> about = {};
  /// If given, of the steps about no pixel only those whose triangles are all among these.
  std::optional<IdSet> among = {};

  bool wants(const Event& event) const;
};

/// The triangles that occur in `window`: those that the run's steps at its pixels are about. Where no
/// step about no pixel names such a triangle, the others of its face that are named come with it, as
/// an algorithm may order whole faces and call each by one of its triangles.
IdSet triangles_at(const TracedRun& run, const PixelBox& window, const Scene& scene);

}  // namespace hsr
