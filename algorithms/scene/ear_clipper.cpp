#include "scene/ear_clipper.h"

#include <algorithm>
#include <array>

#include "scene/orientation.h"

namespace hsr {

EarClipper::EarClipper(std::span<const glm::dvec2> outline)
    : points_(outline),
      grid_(outline),
      previous_(outline.size()),
      next_(outline.size()),
      version_(outline.size(), 0),
      watchers_(outline.size(), none),
      kind_(outline.size()),
      left_(static_cast<std::uint32_t>(outline.size())) {
  for (Node i = 0; i < left_; ++i) {
    previous_[i] = i == 0 ? left_ - 1 : i - 1;
    next_[i] = i + 1 == left_ ? 0 : i + 1;
  }
  for (Node i = 0; i < left_; ++i) {
    classify(i);
  }
}

bool EarClipper::clip(std::vector<CornerTriple>& triangles) {
  triangles_ = &triangles;
  bool fills = true;
  while (left_ > 3) {
    if (const Node spike = take(spikes_); spike != none) {
      cut(spike);
    } else if (const Node candidate = take(candidates_); candidate != none) {
      cut_if_ear(candidate);
    } else if (const Node straight = take(straight_); straight != none) {
      cut(straight);
    } else {
      fills = false;
      cut(any_corner());
    }
  }
  const Node last = next_[cursor_];
  triangles.push_back({previous_[last], last, next_[last]});
  return fills && kind_[last] != Kind::right;
}

int EarClipper::turn(Node node) const {
  return orientation(points_[previous_[node]], points_[node], points_[next_[node]]);
}

/// Notes what kind of corner it is now. Among corners within an ear there is always one that turns
/// right, or back on itself, at the greatest distance from the ear's base: others need no look.
void EarClipper::classify(Node node) {
  const int side = turn(node);
  const glm::dvec2 in = points_[node] - points_[previous_[node]];
  const glm::dvec2 out = points_[next_[node]] - points_[node];
  const bool goes_on = in.x * out.x + in.y * out.y > 0;  // its sign is sure where there is no turn
  kind_[node] = side > 0 ? Kind::left : side < 0 ? Kind::right : goes_on ? Kind::straight : Kind::spike;
  Entry entry{node, version_[node]};
  switch (kind_[node]) {
    case Kind::left:
      candidates_.push_back(entry);
      break;
    case Kind::spike:
      spikes_.push_back(entry);
      break;
    case Kind::straight:
      straight_.push_back(entry);
      break;
    case Kind::right:
      break;
  }
}

/// The next corner of a list that is still as it was put there, or none.
EarClipper::Node EarClipper::take(std::deque<Entry>& list) {
  while (!list.empty()) {
    const Entry entry = list.front();
    list.pop_front();
    if (version_[entry.node] == entry.version) {
      return entry.node;
    }
  }
  return none;
}

/// Cuts the corner if it is an ear, or else has what blocks it remember it.
void EarClipper::cut_if_ear(Node node) {
  const Node blocker = find_blocker(node);
  if (blocker == none) {
    cut(node);
  } else {
    watch(blocker, node);
  }
}

/// A corner for which the ear must not be cut (yet), or none.
EarClipper::Node EarClipper::find_blocker(Node ear) const {
  const Node a = previous_[ear];
  const Node c = next_[ear];
  const auto [low_x, high_x] = std::minmax({points_[a].x, points_[ear].x, points_[c].x});
  const auto [low_y, high_y] = std::minmax({points_[a].y, points_[ear].y, points_[c].y});
  Node found = none;
  Node reversed = none;
  grid_.visit_triangle({points_[a], points_[ear], points_[c]}, [&](Node node) {
    const glm::dvec2& point = points_[node];
    const bool can_block = kind_[node] == Kind::right || kind_[node] == Kind::spike;
    const bool near =
        can_block && point.x >= low_x && point.x <= high_x && point.y >= low_y && point.y <= high_y;
    if (!near || node == a || node == ear || node == c) {
      return false;
    }
    if (intrudes(node, a, ear, c)) {
      found = node;
    } else if (runs_back(node, ear)) {
      reversed = node;
    }
    return found != none;
  });
  return found == none && reversed != none && !is_inside(ear) ? reversed : found;
}

/// Whether `node` lies within the triangle a b c, or on its border with an edge that leads inside.
bool EarClipper::intrudes(Node node, Node a, Node b, Node c) const {
  const glm::dvec2& point = points_[node];
  const std::array<std::array<const glm::dvec2*, 2>, 3> sides{
      {{&points_[a], &points_[b]}, {&points_[b], &points_[c]}, {&points_[c], &points_[a]}}};
  std::array<int, 3> place{};
  for (std::size_t k = 0; k < 3; ++k) {
    place[k] = orientation(*sides[k][0], *sides[k][1], point);
    if (place[k] < 0) {
      return false;
    }
  }
  // An edge from a point on some sides leads inside if its other end is to the left of all those.
  const auto leads_inside = [&](Node end) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (place[k] == 0 && orientation(*sides[k][0], *sides[k][1], points_[end]) <= 0) {
        return false;
      }
    }
    return true;
  };
  return leads_inside(previous_[node]) || leads_inside(next_[node]);
}

/// Whether `node` stands where the ear does and the outline runs through it the opposite way, along
/// both sides of the ear.
bool EarClipper::runs_back(Node node, Node ear) const {
  const glm::dvec2& tip = points_[ear];
  const auto same_direction = [&](const glm::dvec2& p, const glm::dvec2& q) {
    return orientation(tip, p, q) == 0 && (p.x > tip.x) == (q.x > tip.x) && (p.x < tip.x) == (q.x < tip.x) &&
           (p.y > tip.y) == (q.y > tip.y) && (p.y < tip.y) == (q.y < tip.y);
  };
  return points_[node] == tip && same_direction(points_[previous_[node]], points_[next_[ear]]) &&
         same_direction(points_[next_[node]], points_[previous_[ear]]);
}

/// Whether what is left of the outline winds about the inside of the ear's triangle, which no edge
/// crosses. Asked where the outline also runs back along the ear: then that may be the strip of no
/// width between two edges, with the outside beyond, and turning left is not enough. False also when
/// the triangle is so thin that no double within it was found.
bool EarClipper::is_inside(Node ear) const {
  const glm::dvec2& a = points_[previous_[ear]];
  const glm::dvec2& b = points_[ear];
  const glm::dvec2& c = points_[next_[ear]];
  const glm::dvec2 middle((a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3);
  if (orientation(a, b, middle) <= 0 || orientation(b, c, middle) <= 0 || orientation(c, a, middle) <= 0) {
    return false;
  }
  int turns = 0;  // crossings of the ray from `middle` to the right: upward ones less downward ones
  Node node = ear;
  do {
    const glm::dvec2& p = points_[node];
    const glm::dvec2& q = points_[next_[node]];
    if ((p.y <= middle.y) != (q.y <= middle.y)) {
      const int side = orientation(p, q, middle);
      turns += p.y <= middle.y ? (side > 0 ? 1 : 0) : (side < 0 ? -1 : 0);
    }
    node = next_[node];
  } while (node != ear);
  return turns > 0;
}

void EarClipper::cut(Node node) {
  const Node before = previous_[node];
  const Node after = next_[node];
  triangles_->push_back({before, node, after});
  next_[before] = after;
  previous_[after] = before;
  grid_.remove(node);
  ++version_[node];
  --left_;
  cursor_ = after;
  release_watchers(node);
  neighbours_changed(before);
  neighbours_changed(after);
}

void EarClipper::neighbours_changed(Node node) {
  ++version_[node];
  classify(node);
  release_watchers(node);
}

void EarClipper::watch(Node blocker, Node blocked) {
  const Watcher watcher{{blocked, version_[blocked]}, watchers_[blocker]};
  if (free_watcher_ != none) {
    watchers_[blocker] = free_watcher_;
    free_watcher_ = watcher_pool_[free_watcher_].next;
    watcher_pool_[watchers_[blocker]] = watcher;
  } else {
    watchers_[blocker] = static_cast<std::uint32_t>(watcher_pool_.size());
    watcher_pool_.push_back(watcher);
  }
}

void EarClipper::release_watchers(Node blocker) {
  while (watchers_[blocker] != none) {
    const std::uint32_t slot = watchers_[blocker];
    Watcher& watcher = watcher_pool_[slot];
    watchers_[blocker] = watcher.next;
    watcher.next = free_watcher_;
    free_watcher_ = slot;
    candidates_.push_back(watcher.entry);
  }
}

/// A corner to cut where no cut is right: the next that turns left, or else the next at all.
EarClipper::Node EarClipper::any_corner() {
  for (std::uint32_t step = 0; step < left_; ++step) {
    if (kind_[cursor_] == Kind::left) {
      return cursor_;
    }
    cursor_ = next_[cursor_];
  }
  return cursor_;
}

}  // namespace hsr
