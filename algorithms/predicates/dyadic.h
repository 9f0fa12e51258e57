#pragma once

#include <gmpxx.h>

namespace hsr {

/// An exact number m · 2^e with an integer m of any size. Every finite double is one, and sums,
/// differences and products of such numbers are such numbers again: no rounding, no overflow.
class Dyadic {
 public:
  Dyadic() = default;
  /// The number that a finite double states.
  Dyadic(double exact);

  /// -1, 0 or 1.
  int sign() const { return sgn(mantissa_); }
  /// The number rounded to a double with 53 bits (towards zero) times 2^exponent, so that neither
  /// overflow nor underflow can occur; the result's absolute value is in [0.5, 1), or 0.
  double rounded(long& exponent) const;

  /// a / b in lowest terms; b must not be 0.
  friend mpq_class quotient(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a);

 private:
  mpz_class mantissa_;
  long exponent_ = 0;
};

}  // namespace hsr
