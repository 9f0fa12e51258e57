#include "scene/ear_clipper.h"

#include <algorithm>

#include "scene/orientation.h"

namespace hsr {

EarClipper::EarClipper(std::span<const glm::dvec2> outline)
    : points_(outline),
      grid_(outline),
      previous_(outline.size()),
      next_(outline.size()),
      version_(outline.size(), 0),
      watchers_(outline.size(), none),
      left_(static_cast<std::uint32_t>(outline.size())) {
  for (Node i = 0; i < left_; ++i) {
    previous_[i] = i == 0 ? left_ - 1 : i - 1;
    next_[i] = i + 1 == left_ ? 0 : i + 1;
    candidates_.push_back({i, 0});
  }
}

bool EarClipper::clip(std::vector<CornerTriple>& triangles) {
  triangles_ = &triangles;
  bool fills = true;
  while (left_ > 3) {
    if (!candidates_.empty()) {
      const Entry entry = candidates_.front();
      candidates_.pop_front();
      if (is_current(entry)) {
        consider(entry.node);
      }
    } else if (!flat_.empty()) {
      const Entry entry = flat_.front();
      flat_.pop_front();
      if (is_current(entry)) {
        cut(entry.node);
      }
    } else {
      fills = false;
      cut(any_corner());
    }
  }
  const Node last = next_[cursor_];
  triangles.push_back({previous_[last], last, next_[last]});
  return fills && turn(last) >= 0;
}

int EarClipper::turn(Node node) const {
  return orientation(points_[previous_[node]], points_[node], points_[next_[node]]);
}

void EarClipper::consider(Node node) {
  const int side = turn(node);
  if (side == 0) {
    flat_.push_back({node, version_[node]});
  }
  if (side <= 0) {
    return;
  }
  const Node blocker = find_blocker(node);
  if (blocker == none) {
    cut(node);
  } else {
    watch(blocker, node);
  }
}

/// A corner with an edge that runs through the inside of the ear's triangle, or none.
EarClipper::Node EarClipper::find_blocker(Node ear) const {
  const Node a = previous_[ear];
  const Node c = next_[ear];
  const auto [low_x, high_x] = std::minmax({points_[a].x, points_[ear].x, points_[c].x});
  const auto [low_y, high_y] = std::minmax({points_[a].y, points_[ear].y, points_[c].y});
  Node found = none;
  grid_.visit_box({low_x, low_y}, {high_x, high_y}, [&](Node node) {
    const glm::dvec2& point = points_[node];
    const bool candidate = next_[node] != none && node != a && node != ear && node != c && point.x >= low_x &&
                           point.x <= high_x && point.y >= low_y && point.y <= high_y;
    if (candidate && intrudes(node, a, ear, c)) {
      found = node;
    }
    return found != none;
  });
  return found;
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

void EarClipper::cut(Node node) {
  const Node before = previous_[node];
  const Node after = next_[node];
  triangles_->push_back({before, node, after});
  next_[before] = after;
  previous_[after] = before;
  next_[node] = none;
  ++version_[node];
  --left_;
  cursor_ = after;
  release_watchers(node);
  neighbours_changed(before);
  neighbours_changed(after);
}

void EarClipper::neighbours_changed(Node node) {
  ++version_[node];
  candidates_.push_back({node, version_[node]});
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
    if (is_current(watcher.entry)) {
      candidates_.push_back(watcher.entry);
    }
  }
}

/// A corner to cut where no cut is right: the next that turns left, or else the next at all.
EarClipper::Node EarClipper::any_corner() {
  for (std::uint32_t step = 0; step < left_; ++step) {
    if (turn(cursor_) > 0) {
      return cursor_;
    }
    cursor_ = next_[cursor_];
  }
  return cursor_;
}

}  // namespace hsr
