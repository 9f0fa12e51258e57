#pragma once

#include <cmath>
#include <limits>

namespace hsr {

/// A real number known only as a double and a proven bound on its distance from the true value.
///
/// Arithmetic on Bounded is ordinary double arithmetic that carries its own error analysis, so that
/// one formula, written once, yields both a value and a bound. With v = 2^-53 (half the distance
/// from 1 to the next double), rounding to nearest gives |fl(x) - x| <= v |fl(x)|, and below the
/// normal range at most 2^-1075. What is left is to pass on the errors of the operands:
///
///   A + B:  |a + b - (A + B)| <= ea + eb
///   A * B:  |a * b - A * B|   <= |a| eb + |b| ea + ea eb
///   A / B:  |a / b - A / B|   <= (ea + |a / b| eb) / (|b| - eb)   where |b| > eb
///
/// The bounds themselves are sums of at most five non-negative doubles, each operation rounding by
/// a factor within 1 ± v; `slack` = 1 + 16 v covers up to eight such roundings. `least_error` is far
/// above anything that underflow can lose. Overflow turns a bound into infinity or NaN, and then no
/// sign is certain.
///
/// Source: the running error analysis of Wilkinson (1963, Rounding Errors in Algebraic Processes);
/// as a filter for exact predicates, Shewchuk (1997, section 4).
struct Bounded {
  static constexpr double v = 0x1p-53;
  static constexpr double slack = 1.0 + 16.0 * v;
  static constexpr double least_error = std::numeric_limits<double>::min();

  double value = 0.0;
  double error = 0.0;

  Bounded() = default;
  /// A number that the double states exactly.
  Bounded(double exact) : value(exact) {}
  Bounded(double approximate, double bound) : value(approximate), error(bound) {}

  /// True when the number is surely above 0. False when it is not, or when that is not certain.
  bool surely_positive() const { return value > error; }
  bool surely_negative() const { return -value > error; }
  /// True when neither sign is certain.
  bool uncertain() const { return !surely_positive() && !surely_negative(); }

  /// A double that the number surely does not lie below (above); NaN if nothing is known.
  double lower() const { return (value - error) - v * std::abs(value - error) * 2.0 - least_error; }
  double upper() const { return (value + error) + v * std::abs(value + error) * 2.0 + least_error; }
};

inline Bounded operator-(const Bounded& a) { return {-a.value, a.error}; }

inline Bounded operator+(const Bounded& a, const Bounded& b) {
  const double sum = a.value + b.value;
  return {sum, (a.error + b.error + Bounded::v * std::abs(sum)) * Bounded::slack};
}

inline Bounded operator-(const Bounded& a, const Bounded& b) { return a + (-b); }

inline Bounded operator*(const Bounded& a, const Bounded& b) {
  const double product = a.value * b.value;
  const double passed_on = std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error;
  return {product, (passed_on + Bounded::v * std::abs(product)) * Bounded::slack + Bounded::least_error};
}

/// Where the divisor may be zero the result has an infinite bound.
inline Bounded operator/(const Bounded& a, const Bounded& b) {
  const double quotient = a.value / b.value;
  // The subtraction is rounded down by another factor, so that the divisor stays a lower bound.
  const double divisor = (std::abs(b.value) - b.error) * (1.0 - 4.0 * Bounded::v);
  if (!(divisor > 0.0)) return {0.0, std::numeric_limits<double>::infinity()};
  const double passed_on = (a.error + std::abs(quotient) * Bounded::slack * b.error) / divisor;
  return {quotient, (passed_on + Bounded::v * std::abs(quotient)) * Bounded::slack + Bounded::least_error};
}

}  // namespace hsr
