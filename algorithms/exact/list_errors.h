#pragma once

#include <cstdint>

#include "exact/exact_answer.h"
#include "frame/fragment_lists.h"

namespace hsr::exact {

/// How depth lists differ from the exact ones.
struct ListErrors {
  std::uint64_t missing = 0;     ///< fragments of the exact lists that are not there
  std::uint64_t extra = 0;       ///< fragments that are not in the exact lists, or there once more
  std::uint64_t inversions = 0;  ///< neighbours, extra ones aside, of which the first is exactly deeper

  ListErrors& operator+=(const ListErrors& other) {
    missing += other.missing;
    extra += other.extra;
    inversions += other.inversions;
    return *this;
  }
};

/// Rows first ... last - 1 of a picture.
struct Rows {
  int first = 0;
  int last = 0;
};

/// Compares the lists of a picture, `width` pixels wide, with the exact lists of its view in some rows. The
/// exact lists are made row by row.
ListErrors measure_list_errors(const FragmentLists& lists, const ExactAnswer& exact, int width, Rows rows,
                               int threads);

}  // namespace hsr::exact
