#include "predicates/dyadic.h"

#include <cassert>
#include <cmath>
#include <cstdint>

namespace hsr {

Dyadic::Dyadic(double exact) {
  assert(std::isfinite(exact));
  int exponent = 0;
  const double fraction = std::frexp(exact, &exponent);
  // 53 bits hold every fraction of a double, so scaling by 2^53 leaves an integer.
  mantissa_ = std::ldexp(fraction, 53);
  exponent_ = mantissa_ == 0 ? 0 : exponent - 53;
}

Dyadic operator-(const Dyadic& a) {
  Dyadic result;
  result.mantissa_ = -a.mantissa_;
  result.exponent_ = a.exponent_;
  return result;
}

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
  if (a.sign() == 0) return b;
  if (b.sign() == 0) return a;
  const Dyadic& high = a.exponent_ >= b.exponent_ ? a : b;
  const Dyadic& low = a.exponent_ >= b.exponent_ ? b : a;
  Dyadic result;
  const auto shift = static_cast<mp_bitcnt_t>(high.exponent_ - low.exponent_);
  mpz_mul_2exp(result.mantissa_.get_mpz_t(), high.mantissa_.get_mpz_t(), shift);
  result.mantissa_ += low.mantissa_;
  result.exponent_ = low.exponent_;
  return result;
}

Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + (-b); }

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
  Dyadic result;
  result.mantissa_ = a.mantissa_ * b.mantissa_;
  result.exponent_ = result.mantissa_ == 0 ? 0 : a.exponent_ + b.exponent_;
  return result;
}

double Dyadic::rounded(long& exponent) const {
  const double fraction = mpz_get_d_2exp(&exponent, mantissa_.get_mpz_t());
  exponent += exponent_;
  return fraction;
}

mpq_class quotient(const Dyadic& a, const Dyadic& b) {
  mpq_class result(a.mantissa_, b.mantissa_);
  const long exponent = a.exponent_ - b.exponent_;
  if (exponent >= 0) {
    result.get_num() <<= static_cast<mp_bitcnt_t>(exponent);
  } else {
    result.get_den() <<= static_cast<mp_bitcnt_t>(-exponent);
  }
  result.canonicalize();
  return result;
}

}  // namespace hsr
