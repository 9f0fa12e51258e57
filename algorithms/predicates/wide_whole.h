#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace hsr {

/// A whole number of N · 64 bits, two's complement, lowest part first. Sums and products that do not fit are
/// the caller's mistake.
template <std::size_t N>
using WideWhole = std::array<std::uint64_t, N>;

namespace wide {

__extension__ using Double64 = unsigned __int128;

template <std::size_t N>
bool negative(const WideWhole<N>& number) {
  return (number[N - 1] >> 63U) != 0;
}

template <std::size_t N>
WideWhole<N> sum(const WideWhole<N>& p, const WideWhole<N>& q) {
  WideWhole<N> result;
  std::uint64_t carry = 0;
  for (std::size_t k = 0; k < N; ++k) {
    const Double64 part = Double64{p[k]} + q[k] + carry;
    result[k] = static_cast<std::uint64_t>(part);
    carry = static_cast<std::uint64_t>(part >> 64U);
  }
  return result;
}

template <std::size_t N>
WideWhole<N> negated(WideWhole<N> number) {
  std::uint64_t carry = 1;
  for (std::uint64_t& part : number) {
    part = ~part + carry;
    carry = carry != 0 && part == 0 ? 1 : 0;
  }
  return number;
}

template <std::size_t N>
WideWhole<N> size_of(const WideWhole<N>& number) {
  return negative(number) ? negated(number) : number;
}

/// Of two numbers whose product fits into R parts.
template <std::size_t R, std::size_t N, std::size_t M>
WideWhole<R> product(const WideWhole<N>& p, const WideWhole<M>& q) {
  const WideWhole<N> a = size_of(p);
  const WideWhole<M> b = size_of(q);
  WideWhole<R> result{};
  for (std::size_t i = 0; i < std::min(N, R); ++i) {
    if (a[i] == 0) continue;  // most parts of most numbers are
    std::uint64_t carry = 0;
    for (std::size_t k = 0; k < M && i + k < R; ++k) {
      const Double64 part = Double64{a[i]} * b[k] + result[i + k] + carry;
      result[i + k] = static_cast<std::uint64_t>(part);
      carry = static_cast<std::uint64_t>(part >> 64U);
    }
    if (i + M < R) result[i + M] = carry;
  }
  return negative(p) != negative(q) ? negated(result) : result;
}

inline WideWhole<1> whole(std::int64_t number) { return {static_cast<std::uint64_t>(number)}; }

/// -1, 0 or 1.
template <std::size_t N>
int sign_of(const WideWhole<N>& number) {
  if (negative(number)) return -1;
  return std::ranges::all_of(number, [](std::uint64_t part) { return part == 0; }) ? 0 : 1;
}

}  // namespace wide
}  // namespace hsr
