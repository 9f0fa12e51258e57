#pragma once

#include <vector>

#include "exact/exact_answer.h"
#include "view/view.h"

namespace hsr::exact {

/// The whole depth list of pixel (i, j), by increasing depth, ties by id: the same as that of
/// ExactAnswer::depth_lists, without preparing the rest of the picture. Triangles that surely lie on
/// one side of the ray through the pixel's centre are put aside by doubles and a proven bound; only
/// those that are left cost more than a few nanoseconds.
std::vector<Fragment> depth_list(const View& view, int i, int j);

}  // namespace hsr::exact
