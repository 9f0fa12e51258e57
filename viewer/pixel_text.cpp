#include "pixel_text.h"

#include <array>
#include <cstddef>
#include <cstdio>
#include <vector>

#include "frame/srgb.h"
#include "step_text.h"
#include "text_layout.h"
#include "trace/sentences.h"

namespace hsr {
namespace {

// Of a longer list the first and the last are shown.
constexpr std::size_t shown_first = 20;
constexpr std::size_t shown_last = 5;

/// Calls show(k) for the places of a list that are shown, and leave_out(count) in their middle.
template <class Show, class LeaveOut>
void for_each_shown(std::size_t size, Show show, LeaveOut leave_out) {
  for (std::size_t k = 0; k < size; ++k) {
    if (size > shown_first + shown_last + 1 && k == shown_first) {
      leave_out(size - shown_first - shown_last);
      k = size - shown_last;
    }
    show(k);
  }
}

std::string number(double value) {
  std::array<char, 40> text{};
  const int length = std::snprintf(text.data(), text.size(), "%.9g", value);
  return {text.data(), static_cast<std::size_t>(length)};
}

float opacity_of(const Scene& scene, std::uint32_t id) {
  const std::uint32_t material = scene.triangles[id].material;
  return material == no_material ? 1.0F : scene.materials[material].opacity;
}

std::string list_text(const PixelStory& story, const View& view) {
  const Scene& scene = *view.scene;
  const std::vector<bool> front = fronts(view, story.list);
  TextTable table({"rank", "triangle", "face", "depth", "opacity", "side", "tie"});
  for_each_shown(
      story.list.size(),
      [&](std::size_t k) {
        const exact::Fragment& fragment = story.list[k];
        table.add_row({std::to_string(k + 1), std::to_string(fragment.id),
                       std::to_string(scene.triangles[fragment.id].face), number(fragment.depth),
                       number(opacity_of(scene, fragment.id)), front[k] ? "front" : "back",
                       fragment.tied ? "as above" : ""});
      },
      [&](std::size_t count) {
        table.add_row({"...", grouped(count), "more", "", "", "", ""});
      });
  return table.text();
}

std::string history_text(const PixelStory& story) {
  const Recording& history = story.history;
  std::optional<std::uint64_t> departure;
  if (story.departure) departure = story.departure->step;
  std::string text;
  for_each_shown(
      history.events.size(),
      [&](std::size_t k) {
        text += step_text(history.first + k, history.total, history.events[k], departure);
      },
      [&](std::size_t count) {
        text += left_out_text(count + (history.total - history.events.size()), "step");
      });
  if (departure && story.history.events.size() > shown_first + shown_last + 1 && *departure > shown_first &&
      *departure + shown_last <= history.events.size()) {
    text +=
        "Among those left out:\n" + step_text(*departure, history.total, story.departure->event, departure);
  }
  return text;
}

std::string color_text(const glm::vec4& color) {
  std::array<char, 64> text{};
  (void)std::snprintf(text.data(), text.size(), "%.4g, %.4g, %.4g, opacity %.4g", double{color.r},
                      double{color.g}, double{color.b}, double{color.a});
  return text.data();
}

std::string answer_text(std::uint32_t id, double depth, const glm::vec4& color) {
  if (id == background_id) return "background; colour " + color_text(color);
  return "triangle " + std::to_string(id) + " at depth " + number(depth) + "; colour " + color_text(color);
}

}  // namespace

std::string to_text(const PixelStory& story, const View& view, const AlgorithmSpec& algorithm) {
  const std::string name(algorithm.algorithm->name);
  std::string text = paragraph(view.scene->name + ", " + algorithm.text() + ": pixel (" +
                               std::to_string(story.i) + ", " + std::to_string(story.j) + ") of " +
                               std::to_string(view.width) + "x" + std::to_string(view.height) + ".");
  text += "\n";
  if (story.covered()) {
    text += "Everything behind the pixel's centre, exactly, nearest first (" +
            counted(story.list.size(), "fragment") + "):\n" + list_text(story, view);
  } else {
    text += "Nothing lies behind the pixel's centre.\n";
  }
  text += "\nWhat " + name + " did here, in its own order (" + counted(story.history.total, "step") + "):\n" +
          history_text(story);
  const std::uint32_t exact_id = story.covered() ? story.list.front().id : background_id;
  const double exact_depth = story.covered() ? story.list.front().depth : 0.0;
  text += "\n" + definition("answer", answer_text(story.id, double{story.depth}, story.color), 0, 8);
  text += definition("exact", answer_text(exact_id, exact_depth, story.exact_color), 0, 8);
  return text + "\n" + paragraph(explanation(view, algorithm, story));
}

}  // namespace hsr
