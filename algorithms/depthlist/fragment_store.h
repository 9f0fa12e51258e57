#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fragment_order.h"
#include "parts.h"
#include "predicates/sample_predicates.h"
#include "trace/trace.h"

namespace hsr {

/// Steps 1 to 4 of depthlist.cpp for one part of the picture: a list of fragments for each pixel.
class FragmentStore {
 public:
  /// More fragments than this are not stored at once (32 MB), unless they are of a single pixel.
  static constexpr std::size_t most_fragments = std::size_t{1} << 22;

  /// Stores every fragment of the part; nothing where they are too many. With `drop_hidden`, those that
  /// surely cannot be seen behind an opaque one that is stored already are left out. `colors` are by id.
  template <class Trace>
  static std::optional<FragmentStore> make(const View& view, const ScreenTriangles& set_up, const Part& part,
                                           const std::vector<glm::vec4>& colors, bool drop_hidden,
                                           SamplePredicates& predicates, const Trace& trace);

  /// The fragments of the pixel at a place of the part, in the order in which they were stored.
  std::span<OrderedFragment> list(std::size_t place) {
    return std::span(fragments_).subspan(begin_[place], begin_[place + 1] - begin_[place]);
  }
  std::size_t size() const { return fragments_.size(); }
  /// The most memory that was held while the lists were made.
  std::size_t bytes() const { return size() * (2 * sizeof(Stored) + sizeof(OrderedFragment)); }
  std::uint64_t dropped() const { return dropped_; }

 private:
  struct Stored {
    std::uint32_t place;
    std::uint32_t index;
  };
  // What is known of a pixel while its fragments come in.
  struct Pixel {
    std::uint32_t count = 0;
    std::uint32_t hider = background_id;  // the nearest opaque fragment that hides what lies behind it
    bool transparent = false;             // a transparent fragment is stored
  };

  FragmentStore(const std::vector<Pixel>& pixels, const std::vector<Stored>& stored, std::uint64_t dropped);

  std::vector<std::size_t> begin_;  // per pixel and one more
  std::vector<OrderedFragment> fragments_;
  std::uint64_t dropped_ = 0;
};

template <class Trace>
std::optional<FragmentStore> FragmentStore::make(const View& view, const ScreenTriangles& set_up,
                                                 const Part& part, const std::vector<glm::vec4>& colors,
                                                 bool drop_hidden, SamplePredicates& predicates,
                                                 const Trace& trace) {
  // 1. Every pixel's list is empty.
  std::vector<Pixel> pixels(part.pixel_count());
  std::vector<Stored> stored;
  std::uint64_t dropped = 0;
  // 2. Take the triangles one after the other.
  for (const std::uint32_t index : part.candidates) {
    const SampleTriangle& triangle = set_up.triangles[index];
    const bool is_opaque = colors[triangle.id].a >= 1.0F;
    const PixelBox box = part.within(set_up.boxes[index]);
    // 3. For each pixel whose centre the triangle covers
    for (int j = box.first_j; j <= box.last_j; ++j) {
      const double b = centre_b(view.height, j);
      for (int i = box.first_i; i <= box.last_i; ++i) {
        const double a = centre_a(view.width, i);
        if (!predicates.covers(triangle, a, b)) continue;
        // 4. add a fragment to its list.
        Pixel& pixel = pixels[part.place(i, j)];
        if (drop_hidden && pixel.hider != background_id) {
          const SampleTriangle& hider = set_up.triangles[pixel.hider];
          const int order = predicates.compare_depth(triangle, hider, a, b);
          if (order > 0) {
            ++dropped;
            if constexpr (Trace::active) {
              trace.add(
                  {.kind = EventKind::fragment_dropped, .i = i, .j = j, .p = triangle.id, .q = hider.id});
            }
            continue;
          }
          if (order < 0 && is_opaque && !pixel.transparent) pixel.hider = index;
        } else if (is_opaque && !pixel.transparent) {
          // A transparent fragment stored before might tie with this one, and then count in its place.
          pixel.hider = index;
        }
        pixel.transparent = pixel.transparent || !is_opaque;
        if (stored.size() == most_fragments && part.pixel_count() > 1) return std::nullopt;
        stored.push_back({part.place(i, j), index});
        ++pixel.count;
        if constexpr (Trace::active) {
          trace.add({.kind = EventKind::fragment_stored,
                     .i = i,
                     .j = j,
                     .p = triangle.id,
                     .number = pixel.count,
                     .value = 1.0 / triangle.inverse_depth.at(a, b)});
        }
      }
    }
  }
  return FragmentStore(pixels, stored, dropped);
}

}  // namespace hsr
