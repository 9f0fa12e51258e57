#pragma once

#include <cstdint>
#include <functional>

#include "scene/scene.h"

namespace hsr {

/// What kind of step an algorithm made. The comments say which fields of Event it fills in beside
/// `p`, the triangle that it is about (background_id where there is none).
enum class EventKind : std::uint8_t {
  // Painter's algorithm and Newell's
  key_given,  ///< value: the sort key, eye depth in scene units
  placed,     ///< number: the place in the order, from 0; the first is painted first
  // Newell's: P is p, the farthest that is left, and Q is q
  compared,   ///< number: the test, 1 to 6; passed: it shows that P may be painted before Q
  exchanged,  ///< q is to be painted before p, and is marked
  cycled,     ///< q is marked already, so p and q overlap in a cycle; number: its length
  crossed,    ///< p and q cross each other: neither may be painted before the other
  split,      ///< p is cut by the plane of q; number: pieces so far
  released,   ///< nothing that is left lies behind p, so it is painted next; number: its place
  // A picture
  painted,     ///< at a pixel: p goes over q, whatever their depths; value, other: their eye depths; if not
               ///< `blended`, p ties with q and goes in its place over what q went over
  edge_drawn,  ///< at a pixel: an edge of the face of p goes over everything; no triangle changes
  // The z-buffer
  depth_tested,  ///< at a pixel: p against the stored q; value, other: the eye depths that the compared
                 ///< depths stand for; passed: p is nearer and is stored; number: an Order
  // Lists of fragments
  fragment_stored,   ///< at a pixel: value: eye depth; number: fragments stored there by now
  fragment_dropped,  ///< at a pixel: p lies behind q, which hides it, or the list is full (q background), or
                     ///< p ties with q (number: Order::tied), which counts for both
  list_sorted,       ///< at a pixel: number: its fragments; the colour is blended anew, from nothing
  fragment_taken,    ///< at a pixel: number: rank from 0; value: eye depth; p is blended behind what is
                     ///< nearer, or, if `other` is not 0, its colour times this share of the pixel is added
  centre_shown,      ///< at a pixel whose fragments have areas: id and depth (value) are those of p
  // Ray casting
  ray_started,     ///< at a pixel
  node_entered,    ///< at a pixel: number: the node of the hierarchy; value: eye depth, at most that of entry
  node_passed_by,  ///< at a pixel: number, value as above; passed: the ray meets the node, but behind the
                   ///< nearest hit; otherwise it misses the node
  cell_entered,    ///< at a pixel: number: the cell of the grid; passed: it holds triangles
  triangle_tested,   ///< at a pixel: passed: the ray meets p; value: the eye depth there
  nearest_replaced,  ///< at a pixel: p is nearer than q; value, other: their eye depths; number: an Order
};

/// How p compares with q in depth, as the number of an Event.
enum class Order : std::uint8_t {
  first,    ///< there is no q yet
  nearer,   ///< p is nearer than q
  tied,     ///< as the algorithm sees it, both are equally deep
  farther,  ///< p is farther than q
};

/// One step of an algorithm. Fields that a kind does not use keep their defaults.
struct Event {
  EventKind kind = EventKind::painted;
  bool passed = false;
  bool blended = false;  ///< the colour of p goes over what is there instead of taking its place
  std::int32_t i = -1;   ///< the pixel's column, or -1
  std::int32_t j = -1;   ///< the pixel's row, or -1
  std::uint32_t p = background_id;
  std::uint32_t q = background_id;
  std::uint32_t piece_p = 0;  ///< which piece of p, where triangles are cut; 0 is the whole
  std::uint32_t piece_q = 0;
  std::uint32_t number = 0;
  double value = 0.0;
  double other = 0.0;

  bool operator==(const Event&) const = default;
};

/// Told every event in order.
using EventListener = std::function<void(const Event&)>;

}  // namespace hsr
