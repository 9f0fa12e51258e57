#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "exact/integer_triangle.h"
#include "exact/prepared_triangle.h"
#include "scene/progress.h"
#include "view/view.h"

/// The exact answer: which triangle is nearest at every pixel's centre, in exact arithmetic.
///
/// It shares no code with the algorithms and their predicates: coefficients are computed in whole
/// numbers (GMP) and only then rounded, once; a triangle's pixels are found row by row as the span
/// between exact signs, not pixel by pixel; whatever the rounded coefficients cannot settle is
/// decided in whole numbers.
namespace hsr::exact {

/// One surface at a pixel's centre.
struct Fragment {
  std::uint32_t id = background_id;
  double depth = 0.0;  ///< eye depth, within 2^-39 of the exact one, relative
  bool tied = false;   ///< at exactly the same depth as the fragment before it in the list
};

/// How the decisions behind an answer were made.
struct Decisions {
  std::uint64_t filtered = 0;  ///< by doubles and a proven bound
  std::uint64_t integer = 0;   ///< in whole numbers

  Decisions& operator+=(const Decisions& other) {
    filtered += other.filtered;
    integer += other.integer;
    return *this;
  }
};

/// The nearest triangle of every pixel, row by row; of equal depths the lowest id.
struct Nearest {
  std::vector<std::uint32_t> id;  ///< background_id where nothing covers the centre
  std::vector<double> depth;      ///< as in Fragment; +infinity where nothing covers the centre
  std::uint64_t covered = 0;      ///< pixels that something covers
  Decisions decisions;
};

/// The depth lists of some rows of pixels, one after the other.
struct DepthLists {
  int first_row = 0;
  int width = 0;
  std::vector<std::size_t> begin;   ///< per pixel and one more: where its fragments begin
  std::vector<Fragment> fragments;  ///< by increasing depth, ties by id
};

class Worker;

/// A view prepared for exact questions.
class ExactAnswer {
 public:
  /// The view's scene must outlive the object. May take a few microseconds per triangle.
  ExactAnswer(const View& view, int threads, const Progress& progress = {});
  ExactAnswer(const ExactAnswer&) = delete;
  ExactAnswer& operator=(const ExactAnswer&) = delete;

  /// The exact answer at every pixel.
  Nearest nearest(int threads, const Progress& progress = {}) const;

  /// The whole depth lists of rows first_row ... last_row - 1.
  DepthLists depth_lists(int first_row, int last_row) const;

  /// For questions about single pixels; keeps caches, so use one per thread.
  Worker worker() const;

 private:
  int width_;
  int height_;
  IntegerView view_;
  std::vector<PreparedTriangle> triangles_;  // by id
};

}  // namespace hsr::exact
