#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "predicates/bounded.h"

namespace hsr {

/// A homogeneous vector known as three doubles and one proven bound on the distance of each from its true
/// value: Bounded at a third of the cost, where the three are of one size.
///
/// With v = 2^-53, n(a) = |a.x| + |a.y| + |a.w|, m(a) the greatest of the three, e(a) the bound:
///
///   a · b    passes on    n(a) e(b) + n(b) e(a) + 3 e(a) e(b); its five operations round by at most
///            3 v Σ |a_i b_i| and terms of second order: 4 v n(a) n(b) is enough
///   a × b    passes on, in each component,    2 (m(a) e(b) + m(b) e(a) + e(a) e(b)); two products and a
///            difference round by at most 4 v m(a) m(b) and terms of second order: 5 v m(a) m(b) is enough
///
/// A bound is a sum of at most a dozen products of non-negative doubles, which round by less than 32 v of
/// it: `slack` covers that. `least_error` is far above what underflow can lose in a term.
/// Overflow makes bounds infinite or NaN, and then no sign is certain.
struct FilteredVector {
  static constexpr double v = Bounded::v;
  static constexpr double slack = 1.0 + 64.0 * v;
  static constexpr double least_error = 16.0 * Bounded::least_error;

  double x = 0.0;
  double y = 0.0;
  double w = 0.0;
  double error = 0.0;

  /// n and m above.
  double sum_norm() const { return std::abs(x) + std::abs(y) + std::abs(w); }
  double max_norm() const { return std::max({std::abs(x), std::abs(y), std::abs(w)}); }
};

inline FilteredVector operator-(const FilteredVector& a) { return {-a.x, -a.y, -a.w, a.error}; }

inline FilteredVector operator-(const FilteredVector& a, const FilteredVector& b) {
  FilteredVector difference = {a.x - b.x, a.y - b.y, a.w - b.w, 0.0};
  difference.error = (a.error + b.error + FilteredVector::v * difference.max_norm()) * FilteredVector::slack;
  return difference;
}

inline FilteredVector cross(const FilteredVector& a, const FilteredVector& b) {
  const double size_a = a.max_norm();
  const double size_b = b.max_norm();
  const double passed_on = 2.0 * (size_a * b.error + size_b * a.error + a.error * b.error);
  return {a.y * b.w - a.w * b.y, a.w * b.x - a.x * b.w, a.x * b.y - a.y * b.x,
          (passed_on + 5.0 * FilteredVector::v * size_a * size_b) * FilteredVector::slack +
              FilteredVector::least_error};
}

inline Bounded dot(const FilteredVector& a, const FilteredVector& b) {
  const double size_a = a.sum_norm();
  const double size_b = b.sum_norm();
  const double passed_on = size_a * b.error + (size_b + 3.0 * b.error) * a.error;
  return {a.x * b.x + a.y * b.y + a.w * b.w,
          (passed_on + 4.0 * FilteredVector::v * size_a * size_b) * FilteredVector::slack +
              FilteredVector::least_error};
}

/// A vector made ready to be multiplied with many others: the bound of a · b is
///
///   n(a) (e(b) + 4 v n(b)) + (n(b) + 3 e(b)) e(a),    with what belongs to b in brackets.
struct DotOperand {
  double x = 0.0;
  double y = 0.0;
  double w = 0.0;
  double for_norm = 0.0;   ///< the first bracket
  double for_error = 0.0;  ///< the second

  DotOperand() = default;
  explicit DotOperand(const FilteredVector& b) : x(b.x), y(b.y), w(b.w) {
    const double size = b.sum_norm();
    for_norm = (b.error + 4.0 * FilteredVector::v * size) * FilteredVector::slack;
    for_error = (size + 3.0 * b.error) * FilteredVector::slack;
  }
};

/// The other factor, for as many as there are.
class DotSign {
 public:
  explicit DotSign(const FilteredVector& a) : a_(a), norm_(a.sum_norm()) {}

  /// The sign of a · b: -1 or 1 where it is certain, otherwise 0.
  int operator()(const DotOperand& b) const {
    const double value = a_.x * b.x + a_.y * b.y + a_.w * b.w;
    const double bound =
        (norm_ * b.for_norm + a_.error * b.for_error) * FilteredVector::slack + FilteredVector::least_error;
    if (value > bound) return 1;
    return value < -bound ? -1 : 0;
  }

 private:
  FilteredVector a_;
  double norm_;
};

/// -1 or 1 where the sign is certain, otherwise 0.
inline int certain_sign(const Bounded& value) {
  if (value.surely_positive()) return 1;
  return value.surely_negative() ? -1 : 0;
}

}  // namespace hsr
