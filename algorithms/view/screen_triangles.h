#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "predicates/pixel_box.h"
#include "predicates/sample_triangle.h"
#include "view/view.h"

namespace hsr {

/// The numbers of a view that decide visibility.
Projection projection_of(const View& view);

/// The triangles of a view that may cover some pixel's centre, ready for questions at samples, in id
/// order. The vectors run in parallel.
struct ScreenTriangles {
  std::vector<SampleTriangle> triangles;
  std::vector<PixelBox> boxes;
  std::uint64_t off_screen = 0;         ///< triangles left out because they lie off screen
  std::uint64_t between_centres = 0;    ///< triangles left out because no pixel centre can be covered
  std::uint64_t exact_evaluations = 0;  ///< orientations that the error bound could not settle
};

/// What set_up_screen_triangles may leave out before the set-up proper. A triangle that is not left
/// out here has an empty box and is never asked about, so the frame does not change.
struct ScreenSkips {
  bool off_screen = true;
  bool between_centres = true;
};

/// Sets up every triangle of the view. Triangles that surely cover nothing (no area, or the eye in
/// their plane) are left out always. A pixel's samples lie no farther than `sample_reach` pixels from its
/// centre, right, left, up or down: 0 for the centre alone, less than 1/2. The boxes then hold each
/// pixel of which a sample may be covered.
///
/// With a window, triangles whose boxes lie outside of it are left out too, uncounted.
ScreenTriangles set_up_screen_triangles(const View& view, ScreenSkips skips, int threads,
                                        double sample_reach = 0.0,
                                        const std::optional<PixelBox>& window = std::nullopt);

/// The same for the triangles of `ids` alone, which increase: for whoever knows that no others are asked
/// about.
ScreenTriangles set_up_listed_triangles(const View& view, ScreenSkips skips,
                                        const std::vector<std::uint32_t>& ids);

}  // namespace hsr
