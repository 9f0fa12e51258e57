#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "predicates/pixel_box.h"
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

/// The triangles that the steps of a run at the pixels of `window` are about.
IdSet triangles_at(const TracedRun& run, const PixelBox& window);

}  // namespace hsr
