// One sentence about a pixel's colour.

#include <algorithm>
#include <cmath>
#include <string>

#include "failures/cause.h"
#include "failures/pixel_story.h"
#include "trace/sentences.h"

namespace hsr {

namespace {

std::string triangle(std::uint32_t id) { return "triangle " + std::to_string(id); }

std::string capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string depth_of(const exact::Fragment& fragment) {
  return tell_apart(fragment.depth, fragment.depth).value;
}

/// The sort key of a triangle among the steps; null if it was given none.
const Event* key_of(const PixelStory& story, std::uint32_t id) {
  const auto found = std::ranges::find_if(story.history.events, [&](const Event& event) {
    return event.kind == EventKind::key_given && event.p == id;
  });
  return found == story.history.events.end() ? nullptr : &*found;
}

/// What is nearer about a triangle with the smaller sort key.
std::string nearer_by_key(const AlgorithmSpec& algorithm) {
  const auto key = algorithm.settings.find("key");
  if (key == algorithm.settings.end()) return "its sort key is less";
  if (key->second == "farthest") return "its farthest corner is nearer";
  if (key->second == "nearest") return "its nearest corner is nearer";
  if (key->second == "mean") return "the mean of its corners' depths is less";
  return "its centroid is nearer to the eye";
}

/// The last of Newell's tests that let q be painted before p; null if there is none.
const Event* test_that_let_first(const Scene& scene, const PixelStory& story, std::uint32_t q,
                                 std::uint32_t p) {
  const auto same_face = [&](std::uint32_t one, std::uint32_t other) {
    return one != background_id && other != background_id &&
           scene.triangles[one].face == scene.triangles[other].face;
  };
  const Event* found = nullptr;
  for (const Event& event : story.history.events) {
    if (event.kind != EventKind::compared || !event.passed) continue;
    if (same_face(event.p, q) && same_face(event.q, p)) found = &event;
  }
  return found;
}

/// The name of the algorithm whose steps are told: a fast version tells those of the textbook's.
std::string_view teller(const AlgorithmSpec& algorithm) {
  const Algorithm& row = *algorithm.algorithm;
  return row.variant_of.empty() ? row.name : row.variant_of;
}

/// Why p was painted after q.
std::string why_painted_later(const Scene& scene, const AlgorithmSpec& algorithm, const PixelStory& story,
                              std::uint32_t p, std::uint32_t q) {
  if (teller(algorithm) == "none") return "it comes later in the file";
  const Event* const test = test_that_let_first(scene, story, q, p);
  if (test != nullptr) {
    return "test " + std::to_string(test->number) + " let " + triangle(test->p) + " go before " +
           triangle(test->q);
  }
  const Event* const key_p = key_of(story, p);
  const Event* const key_q = key_of(story, q);
  if (teller(algorithm) != "painter" || key_p == nullptr || key_q == nullptr) {
    return "no test showed that it must come earlier";
  }
  if (key_p->value == key_q->value) return "their keys are equal and it comes later in the file";
  const TwoNumbers keys = tell_apart(key_p->value, key_q->value);
  return nearer_by_key(algorithm) + " (" + keys.value + " against " + keys.other + ")";
}

/// What happened at the step at which the algorithm left the exact answer.
std::string what_happened(const Scene& scene, const AlgorithmSpec& algorithm, const PixelStory& story) {
  const Event& event = story.departure->event;
  const TwoNumbers depth = tell_apart(event.value, event.other);
  const std::string name(algorithm.algorithm->name);
  const bool tied = static_cast<Order>(event.number) == Order::tied;
  switch (event.kind) {
    case EventKind::painted:
      return name + " painted " + triangle(event.p) + " after " + triangle(event.q) + ", because " +
             why_painted_later(scene, algorithm, story, event.p, event.q);
    case EventKind::depth_tested:
      if (event.passed) {
        return name + " took " + triangle(event.p) + ", as stored at " + depth.value + ", for nearer than " +
               triangle(event.q) + ", as stored at " + depth.other;
      }
      if (tied) {
        return triangle(event.p) + " and " + triangle(event.q) + " are stored at the same depth, " +
               depth.value + ", so " + name + " kept the one that came first";
      }
      return name + " took " + triangle(event.p) + ", as stored at " + depth.value + ", for farther than " +
             triangle(event.q) + ", as stored at " + depth.other;
    case EventKind::triangle_tested:
      if (!event.passed) return "the ray test of " + name + " missed " + triangle(event.p);
      return "the ray test of " + name + " met " + triangle(event.p) + " at depth " + depth.value +
             ", which was not the nearest that it computed";
    case EventKind::nearest_replaced:
      return "the ray test of " + name + " computed " + depth.value + " for " + triangle(event.p) + " and " +
             depth.other + " for " + triangle(event.q);
    default:
      return capital(sentence(event));
  }
}

/// The triangle that the step took in place of an admissible one; background_id if it took none.
std::uint32_t taken(const Event& event) {
  switch (event.kind) {
    case EventKind::depth_tested:
      return event.passed ? event.p : event.q;
    case EventKind::painted:
    case EventKind::nearest_replaced:
    case EventKind::fragment_taken:
    case EventKind::centre_shown:
      return event.p;
    default:
      return background_id;
  }
}

/// Which triangle should be seen in place of `shown`, and how deep both are.
std::string what_is_right(const PixelStory& story, std::uint32_t shown) {
  const exact::Fragment& nearest = story.list.front();
  if (shown == background_id) {
    return triangle(nearest.id) + " lies here at depth " + depth_of(nearest);
  }
  const exact::Fragment* const fragment = story.fragment_of(shown);
  if (fragment == nullptr) {
    return triangle(nearest.id) + " lies here at depth " + depth_of(nearest) + " and " + triangle(shown) +
           " does not cover the pixel's centre";
  }
  const TwoNumbers depth = tell_apart(nearest.depth, fragment->depth);
  return triangle(nearest.id) + " is nearer here than " + triangle(shown) + ": " + depth.value + " against " +
         depth.other;
}

std::string wrong(const Scene& scene, const AlgorithmSpec& algorithm, const PixelStory& story) {
  if (!story.covered()) {
    return "Wrong: " + triangle(story.id) + " is shown, although nothing covers the pixel's centre.";
  }
  const std::string shown = story.id == background_id ? "the background" : triangle(story.id);
  if (!story.departure) {
    return "Wrong: " + shown + " is shown, because " + std::string(algorithm.algorithm->name) +
           " never found " + triangle(story.list.front().id) + " at the pixel's centre; " +
           what_is_right(story, story.id) + ".";
  }
  // The one that came first in place of the nearest need not be the one that is seen at the end.
  const std::uint32_t first = taken(story.departure->event);
  const bool replaced = first != background_id && story.id != background_id && first != story.id;
  std::string text = "Wrong: " + what_happened(scene, algorithm, story) + ", although " +
                     what_is_right(story, replaced ? first : story.id);
  if (replaced) text += "; later " + triangle(story.id) + " took its place and is the one that is seen";
  return text + ".";
}

std::size_t tied_with_nearest(const PixelStory& story) {
  std::size_t count = 1;
  while (count < story.list.size() && story.list[count].tied) ++count;
  return count;
}

/// What is blended with the nearest, if anything shows through.
std::string about_color(const AlgorithmSpec& algorithm, const PixelStory& story) {
  float difference = 0.0F;
  for (int k = 0; k < 3; ++k) {
    difference = std::max(difference, std::abs(story.color[k] - story.exact_color[k]));
  }
  const bool has_areas = std::ranges::any_of(story.history.events, [](const Event& event) {
    return event.kind == EventKind::fragment_taken && event.other > 0.0;
  });
  if (has_areas) return "; its colour is the mean over the pixel's area";
  if (difference > visible_difference) {
    return "; its colour differs by " + tell_apart(difference, difference).value +
           " from the whole list blended in order (transparency: " +
           std::string(algorithm.algorithm->traits.transparency) + ")";
  }
  return "";
}

std::string right(const AlgorithmSpec& algorithm, const PixelStory& story) {
  if (!story.covered()) return "Nothing covers the pixel's centre, so the background is shown.";
  const std::size_t tied = tied_with_nearest(story);
  std::string text = capital(triangle(story.id)) + " is shown, at depth " + depth_of(story.list.front());
  if (tied > 1) {
    text += ", where it is exactly as near as " + std::to_string(tied - 1) +
            (tied == 2 ? " other: either is right" : " others: each is right");
  } else if (story.list.size() == 1) {
    text += ", the only one here";
  } else {
    const exact::Fragment& next = story.list[1];
    text += ", the nearest of " + std::to_string(story.list.size()) + " (the next is " + triangle(next.id) +
            " at " + tell_apart(next.depth, story.list.front().depth).value + ")";
  }
  return text + about_color(algorithm, story) + ".";
}

}  // namespace

std::string explanation(const View& view, const AlgorithmSpec& algorithm, const PixelStory& story) {
  const bool is_right = story.covered() ? story.admissible(story.id) : story.id == background_id;
  return is_right ? right(algorithm, story) : wrong(*view.scene, algorithm, story);
}

}  // namespace hsr
