#pragma once

#include "algorithm.h"
#include "exact/exact_answer.h"
#include "frame/frame.h"
#include "view/view.h"

namespace hsr::fuzz {

/// Throws Broken, with pixel, got and want, unless every id of the frame is that of the exact answer (or, of
/// algorithms that paint faces, another of a tie) and every depth within 2^-23 of it, of fast versions 2^-19,
/// relative (or, where floats end, the float next to it).
void check_exact_frame(const Frame& frame, const exact::Nearest& nearest, const exact::ExactAnswer& exact,
                       const Algorithm& algorithm);

/// Throws Broken unless the exact answer and its depth lists are those of plain rational arithmetic:
/// ids, ties and order equal, depths within 2^-39, relative.
void check_exact_answer(const exact::ExactAnswer& exact, const exact::Nearest& nearest, const View& view);

}  // namespace hsr::fuzz
