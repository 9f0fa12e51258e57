#pragma once

#include <cstdint>
#include <deque>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "scene/corner_grid.h"
#include "scene/triangulate.h"

namespace hsr {

/// Ear clipping of one plane outline that winds counter-clockwise (by area), with exact decisions.
///
/// A corner is an ear if it turns left and no edge of what is left of the outline runs through the
/// inside of the triangle that it forms with its neighbours. Only edges with an end in the closed
/// triangle can (others would have to cross an edge), so corners there are looked at; touching the
/// triangle from outside, or lying along its sides, does no harm: that is how bridges to holes and
/// outlines that touch themselves are cut rightly. Only where the outline also runs back along the
/// two sides must the winding number tell whether the triangle is inside. Spikes, which enclose
/// nothing, are cut first; corners straight on when no ear is left; where even those are missing the
/// outline crosses itself and a corner is cut regardless.
///
/// A corner that is blocked is only looked at again when its neighbours or the blocking corner
/// change, and corners are found through a grid, so that time is close to linear on usual outlines.
class EarClipper {
 public:
  explicit EarClipper(std::span<const glm::dvec2> outline);

  /// Appends n - 2 triangles. Returns whether no corner had to be cut regardless. Call once.
  bool clip(std::vector<CornerTriple>& triangles);

 private:
  using Node = std::uint32_t;
  static constexpr Node none = 0xFFFFFFFFU;

  /// Where a corner turns: nowhere or, as a spike, back on itself (also where two corners coincide).
  enum class Kind : std::uint8_t { left, right, straight, spike };

  /// A corner as it stood when it was put on a list: stale once its neighbours have changed.
  struct Entry {
    Node node;
    std::uint32_t version;
  };
  /// A blocked corner in the list of the corner that blocks it.
  struct Watcher {
    Entry entry;
    std::uint32_t next;
  };

  int turn(Node node) const;
  void classify(Node node);
  Node find_blocker(Node ear) const;
  bool intrudes(Node node, Node a, Node b, Node c) const;
  bool runs_back(Node node, Node ear) const;
  bool is_inside(Node ear) const;
  Node take(std::deque<Entry>& list);
  void cut_if_ear(Node node);
  void cut(Node node);
  void neighbours_changed(Node node);
  void watch(Node blocker, Node blocked);
  void release_watchers(Node blocker);
  Node any_corner();

  std::span<const glm::dvec2> points_;
  CornerGrid grid_;
  std::vector<Node> previous_;
  std::vector<Node> next_;
  std::vector<std::uint32_t> version_;   // how often the neighbours have changed
  std::vector<std::uint32_t> watchers_;  // per corner the first of its list in watcher_pool_
  std::vector<Kind> kind_;
  std::vector<Watcher> watcher_pool_;
  std::uint32_t free_watcher_ = none;
  std::deque<Entry> spikes_;
  std::deque<Entry> candidates_;
  std::deque<Entry> straight_;
  std::vector<CornerTriple>* triangles_ = nullptr;
  Node cursor_ = 0;  // some corner that is left
  std::uint32_t left_;
};

}  // namespace hsr
