#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "abuffer/coverage.h"
#include "parts.h"
#include "trace/trace.h"

namespace hsr {

/// A triangle in a pixel.
struct PixelFragment {
  std::uint32_t index = 0;  ///< into ScreenTriangles::triangles
  Coverage coverage;
};

/// What is stored, beside scene and view.
struct StoreRules {
  const SamplePattern& pattern;
  const std::vector<glm::vec4>& colors;  ///< by id
  std::optional<std::uint32_t> limit;    ///< of fragments in a pixel; those that come later are lost
  bool drop_hidden = false;  ///< leave out what surely lies behind an opaque fragment that fills the pixel
};

/// Steps 1 to 4 of abuffer.cpp for one part of the picture: a list of fragments for each pixel.
class PixelStore {
 public:
  /// More fragments than this are not stored at once (64 MB), unless they are of a single pixel.
  static constexpr std::size_t most_fragments = std::size_t{1} << 22;

  /// Stores every fragment of the part; nothing where they are too many.
  template <class Trace>
  static std::optional<PixelStore> make(const View& view, const ScreenTriangles& set_up, const Part& part,
                                        const StoreRules& rules, SamplePredicates& predicates,
                                        const Trace& trace);

  /// The fragments of the pixel at a place of the part, in the order in which they were stored.
  std::span<const PixelFragment> list(std::size_t place) const {
    return std::span(fragments_).subspan(begin_[place], begin_[place + 1] - begin_[place]);
  }
  std::size_t size() const { return fragments_.size(); }
  std::uint64_t hidden() const { return hidden_; }
  std::uint64_t lost() const { return lost_; }
  /// The most memory that was held while the lists were made.
  std::size_t bytes() const { return size() * (2 * sizeof(Stored) + sizeof(PixelFragment)); }

 private:
  struct Stored {
    std::uint32_t place;
    PixelFragment fragment;
  };
  // What is known of a pixel while its fragments come in.
  struct Pixel {
    std::uint32_t count = 0;
    std::uint32_t hider = background_id;  // an opaque fragment that fills the pixel
    bool transparent = false;             // a transparent fragment is stored
  };
  PixelStore() = default;
  void sort_by_pixel(const std::vector<Pixel>& pixels, const std::vector<Stored>& stored);

  std::vector<std::size_t> begin_;  // per pixel and one more
  std::vector<PixelFragment> fragments_;
  std::uint64_t hidden_ = 0;
  std::uint64_t lost_ = 0;
};

template <class Trace>
std::optional<PixelStore> PixelStore::make(const View& view, const ScreenTriangles& set_up, const Part& part,
                                           const StoreRules& rules, SamplePredicates& predicates,
                                           const Trace& trace) {
  // 1. Every pixel's list is empty.
  std::vector<Pixel> pixels(part.pixel_count());
  std::vector<Stored> stored;
  PixelStore store;
  // 2. Take the triangles one after the other.
  for (const std::uint32_t index : part.candidates) {
    const SampleTriangle& triangle = set_up.triangles[index];
    const bool is_opaque = rules.colors[triangle.id].a >= 1.0F;
    const PixelBox box = part.within(set_up.boxes[index]);
    for (int j = box.first_j; j <= box.last_j; ++j) {
      const double b = centre_b(view.height, j);
      for (int i = box.first_i; i <= box.last_i; ++i) {
        const double a = centre_a(view.width, i);
        // 3. Which samples of the pixel does it cover?
        const Coverage coverage = coverage_of(triangle, rules.pattern, a, b, predicates);
        if (!coverage.any()) continue;
        // 4. Add a fragment to the pixel's list, unless it cannot be seen or finds no room.
        Pixel& pixel = pixels[part.place(i, j)];
        const bool is_hidden =
            pixel.hider != background_id && surely_nearer(set_up.triangles[pixel.hider], triangle, a, b);
        if (is_hidden || (rules.limit && pixel.count == *rules.limit)) {
          ++(is_hidden ? store.hidden_ : store.lost_);
          if constexpr (Trace::active) {
            trace.add({.kind = EventKind::fragment_dropped,
                       .i = i,
                       .j = j,
                       .p = triangle.id,
                       .q = is_hidden ? set_up.triangles[pixel.hider].id : background_id});
          }
          continue;
        }
        // A transparent fragment stored before might tie with this one, and then count in its place.
        pixel.transparent = pixel.transparent || !is_opaque;
        if (rules.drop_hidden && !pixel.transparent && coverage.mask == rules.pattern.full() &&
            coverage.centre &&
            (pixel.hider == background_id || surely_nearer(triangle, set_up.triangles[pixel.hider], a, b))) {
          pixel.hider = index;
        }
        if (stored.size() == most_fragments && part.pixel_count() > 1) return std::nullopt;
        stored.push_back({part.place(i, j), {index, coverage}});
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
  store.sort_by_pixel(pixels, stored);
  return store;
}

}  // namespace hsr
