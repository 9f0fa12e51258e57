#include "predicates/bounded.h"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <cmath>
#include <cstdint>
#include <random>

#include "predicates/dyadic.h"

namespace {

// A Bounded beside the exact number that it stands for.
struct Tracked {
  hsr::Bounded bounded;
  mpq_class exact;
};

bool encloses(const Tracked& tracked) {
  if (!std::isfinite(tracked.bounded.error) || !std::isfinite(tracked.bounded.value)) return true;
  return abs(mpq_class(tracked.bounded.value) - tracked.exact) <= mpq_class(tracked.bounded.error);
}

Tracked number(std::mt19937_64& random, int exponent_range) {
  const auto mantissa = static_cast<double>(static_cast<std::int64_t>(random()));
  const int exponent =
      static_cast<int>(random() % static_cast<std::uint64_t>(2 * exponent_range + 1)) - exponent_range - 63;
  const double value = std::ldexp(mantissa, exponent);
  return {hsr::Bounded(value), mpq_class(value)};
}

Tracked combined(const Tracked& p, const Tracked& q, unsigned operation) {
  switch (operation % 4) {
    case 0:
      return {p.bounded + q.bounded, p.exact + q.exact};
    case 1:
      return {p.bounded - q.bounded, p.exact - q.exact};
    case 2:
      return {p.bounded * q.bounded, p.exact * q.exact};
    default:
      if (q.exact == 0) return p;
      return {p.bounded / q.bounded, p.exact / q.exact};
  }
}

}  // namespace

TEST_CASE("predicates: a bound encloses the exact value through long random computations") {
  std::mt19937_64 random(1);
  int finite = 0;
  for (int round = 0; round < 3000; ++round) {
    Tracked value = number(random, 20);
    for (int step = 0; step < 12; ++step) {
      value = combined(value, number(random, 20), static_cast<unsigned>(random() >> 40U));
      REQUIRE(encloses(value));
      REQUIRE(mpq_class(value.exact) >= mpq_class(std::max(value.bounded.lower(), -1e300)));
      REQUIRE(mpq_class(value.exact) <= mpq_class(std::min(value.bounded.upper(), 1e300)));
      if (std::isfinite(value.bounded.error)) ++finite;
      if (value.bounded.surely_positive()) REQUIRE(value.exact > 0);
      if (value.bounded.surely_negative()) REQUIRE(value.exact < 0);
    }
  }
  CHECK(finite > 30000);  // the bounds are of use, not merely infinite
}

TEST_CASE("predicates: a bound encloses the exact value where everything cancels or underflows") {
  std::mt19937_64 random(2);
  for (int round = 0; round < 3000; ++round) {
    const Tracked p = number(random, 2);
    Tracked q = p;
    q.bounded = hsr::Bounded(std::nextafter(p.bounded.value, 1e30));
    q.exact = mpq_class(q.bounded.value);
    const Tracked product = combined(p, q, 2);
    const Tracked square = combined(p, p, 2);
    REQUIRE(encloses(combined(product, square, 1)));
    const Tracked tiny = {hsr::Bounded(std::ldexp(p.bounded.value, -540)),
                          mpq_class(std::ldexp(p.bounded.value, -540))};
    REQUIRE(encloses(combined(tiny, tiny, 2)));
    REQUIRE(encloses(combined(combined(tiny, tiny, 2), tiny, 2)));
  }
}

TEST_CASE("predicates: overflow and division by what may be zero leave nothing certain") {
  const hsr::Bounded huge(1e300);
  CHECK((huge * huge).uncertain());
  CHECK((huge * huge - huge * huge).uncertain());
  const hsr::Bounded perhaps_zero(1e-20, 1e-19);
  CHECK((hsr::Bounded(1.0) / perhaps_zero).uncertain());
  CHECK_FALSE((hsr::Bounded(1.0) / hsr::Bounded(-3.0)).uncertain());
}

TEST_CASE("predicates: dyadic numbers are exact at any exponent") {
  std::mt19937_64 random(3);
  for (int round = 0; round < 2000; ++round) {
    const auto real = [&] {
      const int exponent = static_cast<int>(random() % 2000) - 1070;
      return std::ldexp(static_cast<double>(static_cast<std::int64_t>(random())), exponent - 63);
    };
    const double p = real();
    const double q = real();
    const double r = real();
    const hsr::Dyadic value =
        hsr::Dyadic(p) * hsr::Dyadic(q) - hsr::Dyadic(r) * (hsr::Dyadic(p) + hsr::Dyadic(q));
    const mpq_class want = mpq_class(p) * mpq_class(q) - mpq_class(r) * (mpq_class(p) + mpq_class(q));
    REQUIRE(value.sign() == sgn(want));
    long exponent = 0;
    const double fraction = value.rounded(exponent);
    mpq_class got(fraction);
    if (exponent >= 0) {
      mpq_mul_2exp(got.get_mpq_t(), got.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
    } else {
      mpq_div_2exp(got.get_mpq_t(), got.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
    }
    REQUIRE(abs(got - want) <= abs(want) / (mpz_class(1) << 52));
  }
  CHECK(hsr::Dyadic(0.0).sign() == 0);
  CHECK((hsr::Dyadic(5e-324) - hsr::Dyadic(5e-324)).sign() == 0);
  CHECK((hsr::Dyadic(1e308) + hsr::Dyadic(1e308) - hsr::Dyadic(5e-324)).sign() == 1);
}
