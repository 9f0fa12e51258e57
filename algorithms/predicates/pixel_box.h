#pragma once

#include <array>

#include "predicates/bounded.h"
#include "predicates/homogeneous.h"

namespace hsr {

/// The pixels whose centres (or samples) a triangle may cover: columns first_i ... last_i, rows first_j ...
/// last_j, within the picture; empty when a last lies before its first.
struct PixelBox {
  int first_i = 0;
  int last_i = -1;
  int first_j = 0;
  int last_j = -1;

  bool empty() const { return last_i < first_i || last_j < first_j; }
};

/// Why a triangle's box is what it is.
enum class BoxKind {
  on_screen,        ///< some pixel's centre may be covered
  off_screen,       ///< all of it lies surely outside the picture or outside near and far
  between_centres,  ///< it touches the picture, but no pixel's centre can be covered
};

struct PixelBoxAnswer {
  BoxKind kind = BoxKind::off_screen;
  PixelBox box;  ///< empty unless the kind is on_screen
};

/// The smallest box that can be had from bounds: a pixel outside it is surely not covered. The part
/// nearer than `near_depth` is clipped away first, so corners behind the eye do no harm. With a
/// `sample_reach` above 0 (in pixels, below 1/2), pixels have samples that far to the right, left, top and
/// bottom of the centre, and a pixel outside the box has surely none that is covered.
PixelBoxAnswer pixel_box(const Projection& projection, const std::array<Homogeneous<Bounded>, 3>& corner,
                         double sample_reach = 0.0);

}  // namespace hsr
