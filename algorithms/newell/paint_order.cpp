#include "newell/paint_order.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace hsr {

namespace {

// With the sixth test every cut has its reason in the picture. Without it each plane would cut each
// face that it meets, wherever it lies: n faces fall into some n^3 pieces, of which as many are made as
// show what is wrong.
std::size_t piece_limit(std::size_t faces, const PairTests& tests, bool split) {
  if (!split) return 0;
  return tests.complete() ? std::numeric_limits<std::size_t>::max() : 4 * faces + 64;
}

}  // namespace

template <class Trace>
PaintOrder<Trace>::PaintOrder(const std::vector<WholeFace>& faces, RegionPredicates& predicates,
                              PairTests& tests, bool split, Trace trace)
    : faces_(faces),
      predicates_(predicates),
      tests_(tests),
      most_pieces_(piece_limit(faces.size(), tests, split)),
      trace_(std::move(trace)),
      pieces_of_face_(faces.size(), 1) {
  for (std::uint32_t face = 0; face < faces.size(); ++face) {
    Piece piece;
    piece.face = face;
    piece.region = predicates.region(faces[face].outline);
    if (piece.region.empty()) continue;
    piece.extent = predicates.extent(piece.region, faces[face].plane());
    pieces_.push_back(std::move(piece));
  }
  // 1. Sort by the farthest point. Equal ones keep the file's order.
  list_.resize(pieces_.size());
  for (std::uint32_t place = 0; place < list_.size(); ++place) list_[place] = place;
  std::ranges::stable_sort(list_,
                           [&](std::uint32_t p, std::uint32_t q) { return farthest(p) > farthest(q); });
  gone_.assign(pieces_.size(), false);
  marked_.assign(pieces_.size(), false);
  if constexpr (Trace::active) {
    for (std::uint32_t place = 0; place < list_.size(); ++place) {
      trace_.add({.kind = EventKind::key_given, .p = plane(list_[place]), .value = farthest(list_[place])});
      tell(EventKind::placed, list_[place], list_[place], place);
    }
  }
}

template <class Trace>
void PaintOrder<Trace>::sort(const Progress& progress) {
  constexpr std::size_t report_every = 256;
  std::size_t reported = 0;
  while (step()) {
    if (order_.size() < reported + report_every) continue;
    reported = order_.size();
    const double done = static_cast<double>(reported) / static_cast<double>(pieces_.size());
    if (!report_progress(progress, "ordering", done)) return;
  }
}

// Goes on with the piece at the end of the path until it is painted or another one has to go first.
template <class Trace>
bool PaintOrder<Trace>::step() {
  if (path_.empty()) {
    // 2. Let P be the first piece of the list.
    while (head_ < list_.size() && gone_[list_[head_]]) ++head_;
    if (head_ == list_.size()) return false;
    marked_[list_[head_]] = true;
    path_.push_back({list_[head_], head_});
  }
  const std::uint32_t p = path_.back().piece;
  for (std::size_t place = std::max(path_.back().next, head_); place < list_.size(); ++place) {
    const std::uint32_t q = list_[place];
    if (q == p || gone_[q]) continue;
    // 3. Whatever comes after a piece that lies wholly before P lies before it as well.
    if (tests_.deeper(pieces_[p], pieces_[q])) break;
    path_.back().next = place;
    if (!settle(p, q)) return true;
  }
  release(p);
  return true;
}

// Steps 3 to 6 for one pair. True if P may be painted before Q, or has to be.
template <class Trace>
bool PaintOrder<Trace>::settle(std::uint32_t p, std::uint32_t q) {
  const PairAnswer answer = tests_.answer(pieces_[p], pieces_[q], trace_);
  if (answer == PairAnswer::p_first) return true;
  if (answer == PairAnswer::crossing) {
    // 6. They cross each other.
    ++counts_.crossings;
    tell(EventKind::crossed, p, q, 0);
    if (cut(p, q) || cut(q, p)) return false;
  } else if (!marked_[q]) {
    exchange(p, q);
    return false;
  } else {
    ++counts_.cycles;
    if (break_cycle(p, q)) return false;
  }
  ++counts_.left_wrong;
  return true;
}

// 4. Q has to go first: it moves to the front and is marked.
template <class Trace>
void PaintOrder<Trace>::exchange(std::uint32_t p, std::uint32_t q) {
  ++counts_.exchanges;
  tell(EventKind::exchanged, p, q, 0);
  marked_[q] = true;
  path_.push_back({q, head_});
}

// 5. Q is marked: each piece on the path from Q to P hides the next one, and P hides Q. Some plane of these
// cuts another of them: if all lay on one side of Q's plane, then what Q hides would lie behind it, and so
// would what that hides, and so on to P; but P hides Q.
template <class Trace>
bool PaintOrder<Trace>::break_cycle(std::uint32_t p, std::uint32_t q) {
  std::vector<std::uint32_t> cycle;
  for (auto waiting = path_.rbegin(); waiting != path_.rend(); ++waiting) {
    cycle.push_back(waiting->piece);
    if (waiting->piece == q) break;
  }
  tell(EventKind::cycled, p, q, cycle.size());
  if (cut(p, q) || cut(q, p)) return true;
  return std::ranges::any_of(cycle, [&](std::uint32_t piece) {
    return std::ranges::any_of(cycle, [&](std::uint32_t by) { return cut(piece, by); });
  });
}

// Cuts a piece by the plane of another, if it has corners on both sides.
template <class Trace>
bool PaintOrder<Trace>::cut(std::uint32_t piece, std::uint32_t by) {
  if (piece == by || pieces_.size() >= most_pieces_) return false;
  const RegionLine line = predicates_.crossing(plane(piece), plane(by));
  const Sides sides = predicates_.sides(line, pieces_[piece].region);
  if (!sides.positive || !sides.negative) return false;
  ++counts_.splits;
  for (const bool before : {false, true}) {
    Piece part;
    part.face = pieces_[piece].face;
    part.number = pieces_of_face_[part.face]++;
    part.cuts = pieces_[piece].cuts;
    part.cuts.push_back({plane(by), before});
    part.region = predicates_.clipped(pieces_[piece].region, before ? turned(line) : line);
    part.extent = predicates_.extent(part.region, plane(piece));
    pieces_.push_back(std::move(part));
  }
  tell(EventKind::split, piece, by, pieces_.size());
  // What waits for the piece goes on waiting; the piece itself and what it waits for start anew.
  const auto waiting = std::ranges::find(path_, piece, &Waiting::piece);
  for (auto again = waiting; again != path_.end(); ++again) marked_[again->piece] = false;
  path_.erase(waiting, path_.end());
  gone_[piece] = true;
  pieces_[piece].region = {};
  for (const std::size_t part : {pieces_.size() - 2, pieces_.size() - 1}) {
    insert(static_cast<std::uint32_t>(part));
  }
  for (Waiting& other : path_) other.next = head_;
  return true;
}

template <class Trace>
void PaintOrder<Trace>::insert(std::uint32_t piece) {
  const auto place =
      std::upper_bound(list_.begin() + static_cast<std::ptrdiff_t>(head_), list_.end(), piece,
                       [&](std::uint32_t p, std::uint32_t q) { return farthest(p) > farthest(q); });
  list_.insert(place, piece);
  gone_.push_back(false);
  marked_.push_back(false);
}

// 7. Nothing that is left lies behind P: paint it next.
template <class Trace>
void PaintOrder<Trace>::release(std::uint32_t p) {
  tell(EventKind::released, p, p, order_.size());
  order_.push_back(p);
  gone_[p] = true;
  marked_[p] = false;
  path_.pop_back();
}

template <class Trace>
void PaintOrder<Trace>::tell(EventKind kind, std::uint32_t p, std::uint32_t q, std::size_t number) const {
  if constexpr (Trace::active) {
    Event event = {.kind = kind, .p = plane(p), .piece_p = pieces_[p].number};
    event.number = static_cast<std::uint32_t>(number);
    if (q != p) {
      event.q = plane(q);
      event.piece_q = pieces_[q].number;
    }
    trace_.add(event);
  }
}

template <class Trace>
std::uint64_t PaintOrder<Trace>::bytes() const {
  std::uint64_t bytes = pieces_.capacity() * sizeof(Piece) + list_.capacity() * sizeof(std::uint32_t) +
                        order_.capacity() * sizeof(std::uint32_t) + path_.capacity() * sizeof(Waiting);
  for (const Piece& piece : pieces_) {
    bytes += piece.region.vertices.capacity() * sizeof(RegionVertex) +
             piece.region.lines.capacity() * sizeof(RegionLine) + piece.cuts.capacity() * sizeof(Cut);
  }
  return bytes;
}

template class PaintOrder<NoTrace>;
template class PaintOrder<EventTrace>;

}  // namespace hsr
