#include "trace/sentences.h"

#include <array>
#include <cstdio>
#include <string_view>

namespace hsr {

namespace {

std::string digits(double number, int count) {
  std::array<char, 40> text{};
  const int length = std::snprintf(text.data(), text.size(), "%.*g", count, number);
  return {text.data(), static_cast<std::size_t>(length)};
}

constexpr int few_digits = 4;
constexpr int all_digits = 17;

std::string number_of(double value) { return digits(value, few_digits + 1); }

std::string name(std::uint32_t id, std::uint32_t piece) {
  std::string text = std::to_string(id);
  if (piece != 0) text += " (piece " + std::to_string(piece) + ")";
  return text;
}

std::string pixel(const Event& event) {
  return "pixel (" + std::to_string(event.i) + ", " + std::to_string(event.j) + "): ";
}

std::string triangle_p(const Event& event) { return "triangle " + name(event.p, event.piece_p); }
std::string triangle_q(const Event& event) { return "triangle " + name(event.q, event.piece_q); }
std::string p_and_q(const Event& event) {
  return "P = " + name(event.p, event.piece_p) + " and Q = " + name(event.q, event.piece_q);
}

// What a test of Newell's says, passed and failed.
struct TestWords {
  std::string_view passed;
  std::string_view failed;
};
constexpr std::array<TestWords, 6> newell_tests = {{
    {"P lies wholly behind Q in depth", "their extents in depth overlap"},
    {"their extents in x do not overlap", "their extents in x overlap"},
    {"their extents in y do not overlap", "their extents in y overlap"},
    {"every corner of P lies behind Q's plane", "not every corner of P lies behind Q's plane"},
    {"every corner of Q lies before P's plane", "not every corner of Q lies before P's plane"},
    {"their projections are apart, or P is nowhere nearer in what they share",
     "their projections overlap and somewhere P is nearer"},
}};

std::string compared(const Event& event) {
  std::string text = p_and_q(event) + ", test " + std::to_string(event.number) + ": ";
  if (event.number < 1 || event.number > newell_tests.size()) return text + (event.passed ? "yes" : "no");
  const TestWords& words = newell_tests[event.number - 1];
  if (event.passed) return text.append(words.passed) + ", so P may be painted first";
  text.append(words.failed);
  const bool last = event.number == newell_tests.size();
  return text + (last ? ", and no test is left" : ", so the next test must decide");
}

std::string placed(const Event& event) {
  const std::string key = event.value != 0.0 ? ", whose key is " + number_of(event.value) + "," : "";
  return triangle_p(event) + key + " comes " +
         (event.number == 0 ? "first" : "as number " + std::to_string(std::uint64_t{event.number} + 1)) +
         " in the order";
}

std::string painted(const Event& event) {
  const std::string begin = pixel(event) + triangle_p(event) + " at depth ";
  if (event.q == background_id) return begin + number_of(event.value) + " is painted, the first here";
  if (!event.blended) {
    return begin + number_of(event.value) + " is exactly as deep as " + triangle_q(event) +
           ", takes its place and counts for both";
  }
  const TwoNumbers depth = tell_apart(event.value, event.other);
  const bool hides = event.value > event.other;
  return begin + depth.value + " is painted over " + triangle_q(event) + " at " + depth.other +
         (hides ? ", although that is nearer" : "");
}

std::string depth_tested(const Event& event) {
  const std::string begin = pixel(event) + triangle_p(event) + " at depth ";
  const std::string stored = event.blended ? "stored and its colour blended" : "stored";
  const TwoNumbers depth = tell_apart(event.value, event.other);
  switch (static_cast<Order>(event.number)) {
    case Order::first:
      return begin + number_of(event.value) + " is the first here, so it is " + stored;
    case Order::nearer:
      return begin + depth.value + " is nearer than " + triangle_q(event) + " at " + depth.other +
             ", so it is " + stored;
    case Order::tied:
      return begin + depth.value + " is as deep as " + triangle_q(event) +
             ", which came first and stays, so it is rejected";
    case Order::farther:
      break;
  }
  return begin + depth.value + " is farther than " + triangle_q(event) + " at " + depth.other +
         ", so it is rejected";
}

std::string nearest_replaced(const Event& event) {
  const std::string begin = pixel(event) + triangle_p(event) + " at depth ";
  const TwoNumbers depth = tell_apart(event.value, event.other);
  switch (static_cast<Order>(event.number)) {
    case Order::first:
      return begin + number_of(event.value) + " is the first hit and the nearest so far";
    case Order::tied:
      return begin + depth.value + " is as deep as " + triangle_q(event) +
             " and comes before it in the file, so it is the nearest so far";
    case Order::nearer:
    case Order::farther:
      break;
  }
  return begin + depth.value + " is nearer than " + triangle_q(event) + " at " + depth.other +
         ", so it is the nearest so far";
}

std::string fragment_dropped(const Event& event) {
  const std::string begin = pixel(event) + triangle_p(event);
  if (event.q == background_id) return begin + " is dropped, as the list is full";
  if (static_cast<Order>(event.number) == Order::tied) {
    return begin + " is exactly as deep as " + triangle_q(event) + ", which counts for both";
  }
  return begin + " lies behind " + triangle_q(event) + ", which hides it, so it is dropped";
}

std::string fragment_taken(const Event& event) {
  const std::string begin = pixel(event) + triangle_p(event) + " at depth " + number_of(event.value);
  if (event.other > 0.0) {
    return begin + " is seen in " + digits(100.0 * event.other, few_digits) + " % of the pixel";
  }
  if (event.number == 0) return begin + " is the nearest and is taken first";
  return begin + " is taken as number " + std::to_string(std::uint64_t{event.number} + 1) +
         " and blended behind what is nearer";
}

std::string node_passed_by(const Event& event) {
  const std::string node = "node " + std::to_string(event.number);
  if (!event.passed) return pixel(event) + "the ray misses " + node;
  return pixel(event) + node + " begins at depth " + number_of(event.value) +
         ", behind the nearest hit, so it is not opened";
}

}  // namespace

TwoNumbers tell_apart(double value, double other) {
  int count = few_digits;
  TwoNumbers two = {digits(value, count), digits(other, count)};
  while (value != other && two.value == two.other && count < all_digits) {
    ++count;
    two = {digits(value, count), digits(other, count)};
  }
  // One digit more than the first that differs shows by how much.
  if (count == all_digits) return two;
  return {digits(value, count + 1), digits(other, count + 1)};
}

std::string sentence(const Event& event) {
  switch (event.kind) {
    case EventKind::key_given:
      return triangle_p(event) + " gets the sort key " + number_of(event.value);
    case EventKind::placed:
      return placed(event);
    case EventKind::compared:
      return compared(event);
    case EventKind::exchanged:
      return p_and_q(event) + " change places, so Q is to be painted before P, and is marked";
    case EventKind::cycled:
      return p_and_q(event) + " would change places again: they overlap in a cycle" +
             (event.number > 1 ? " of " + std::to_string(event.number) : "");
    case EventKind::crossed:
      return p_and_q(event) + " cross each other, so neither may be painted before the other";
    case EventKind::split:
      return p_and_q(event) + ": P is cut by Q's plane; there are " + std::to_string(event.number) +
             " pieces so far";
    case EventKind::released:
      return "nothing that is left lies behind P = " + name(event.p, event.piece_p) +
             ", so it is painted next, as number " + std::to_string(std::uint64_t{event.number} + 1);
    case EventKind::painted:
      return painted(event);
    case EventKind::edge_drawn:
      return pixel(event) + "an edge of the face of " + triangle_p(event) + " is drawn over everything";
    case EventKind::depth_tested:
      return depth_tested(event);
    case EventKind::fragment_stored:
      return pixel(event) + triangle_p(event) + " at depth " + number_of(event.value) +
             " is kept in the list, which has " + std::to_string(event.number) + " now";
    case EventKind::fragment_dropped:
      return fragment_dropped(event);
    case EventKind::list_sorted:
      return pixel(event) + "the list of " + std::to_string(event.number) + " is sorted by depth";
    case EventKind::fragment_taken:
      return fragment_taken(event);
    case EventKind::centre_shown:
      return pixel(event) + triangle_p(event) + " at depth " + number_of(event.value) +
             " is the nearest at the centre, so id and depth are its";
    case EventKind::ray_started:
      return pixel(event) + "a ray starts from the eye through the pixel's centre";
    case EventKind::node_entered:
      return pixel(event) + "the ray enters node " + std::to_string(event.number) + " at depth " +
             number_of(event.value);
    case EventKind::node_passed_by:
      return node_passed_by(event);
    case EventKind::cell_entered:
      return pixel(event) + "the ray enters cell " + std::to_string(event.number) +
             (event.passed ? "" : ", which is empty");
    case EventKind::triangle_tested:
      if (!event.passed) return pixel(event) + "the ray misses " + triangle_p(event);
      return pixel(event) + "the ray meets " + triangle_p(event) + " at depth " + number_of(event.value);
    case EventKind::nearest_replaced:
      return nearest_replaced(event);
  }
  return {};
}

}  // namespace hsr
