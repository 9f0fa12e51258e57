#pragma once

#include <array>

#include "algorithm.h"
#include "view/screen_triangles.h"

namespace hsr {

/// The skips of set_up_screen_triangles, for the catalogue rows of every algorithm that uses it.
inline constexpr Skip off_screen_skip = {
    "off-screen", "triangles that lie wholly outside the picture or the depth range are not set up"};
inline constexpr Skip between_centres_skip = {
    "between-centres", "triangles so small that they fall between the centres of the pixels are not set up"};

/// The skip of algorithms that keep lists of fragments.
inline constexpr Skip hidden_skip = {
    "hidden", "fragments behind an opaque one are not kept where nobody asks for lists"};

/// The options for an algorithm that is asked for the faces that it paints: of those between pixel
/// centres too.
inline RenderOptions options_for_faces(const RenderOptions& options, const Frame& frame) {
  RenderOptions changed = options;
  if (frame.faces) changed.skips_off.insert(std::string(between_centres_skip.name));
  return changed;
}

/// Sets up the view's triangles as the options allow and reports what was left out. Samples lie no
/// farther than `sample_reach` pixels from the centre of theirs, right, left, up or down.
///
/// With a window, only the triangles that reach it: for algorithms all of whose steps are about pixels that
/// a triangle covers.
inline ScreenTriangles set_up_with_skips(const View& view, const RenderOptions& options, RenderReport& report,
                                         double sample_reach = 0.0,
                                         const std::optional<PixelBox>& window = std::nullopt) {
  const ScreenSkips skips = {options.uses(off_screen_skip.name), options.uses(between_centres_skip.name)};
  ScreenTriangles set_up = set_up_screen_triangles(view, skips, options.threads, sample_reach, window);
  report.skipped[std::string(off_screen_skip.name)] = set_up.off_screen;
  report.skipped[std::string(between_centres_skip.name)] = set_up.between_centres;
  report.counters["exact_evaluations"] = set_up.exact_evaluations;
  report.bytes += set_up.triangles.capacity() * sizeof(SampleTriangle) +
                  set_up.boxes.capacity() * sizeof(PixelBox) +
                  view.scene->positions.size() * sizeof(Homogeneous<Bounded>);
  return set_up;
}

}  // namespace hsr
