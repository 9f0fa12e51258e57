#include "radix_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

namespace hsr {

namespace {

constexpr unsigned digit_bits = 11;
constexpr std::size_t digit_values = std::size_t{1} << digit_bits;

template <class Key>
struct Keyed {
  Key key;
  std::uint32_t place;
};

// A key that increases as the number decreases. The bits of an IEEE number, taken as an integer, are in
// order, negative ones the wrong way round.
template <class Key, class Number>
Key descending_key(Number number) {
  constexpr Key sign = Key{1} << (8 * sizeof(Key) - 1);
  const Key bits = std::bit_cast<Key>(number + Number{0});  // -0 becomes 0
  return (bits & sign) != 0 ? bits : static_cast<Key>(~bits & ~sign);
}

template <class Key>
std::size_t digit(Key key, unsigned pass) {
  return static_cast<std::size_t>(key >> (pass * digit_bits)) & (digit_values - 1);
}

template <class Key, class Number>
std::vector<std::uint32_t> order_of(std::span<const Number> numbers) {
  constexpr unsigned passes = (8 * sizeof(Key) + digit_bits - 1) / digit_bits;
  std::vector<Keyed<Key>> from(numbers.size());
  std::vector<std::array<std::uint32_t, digit_values>> counts(passes);
  for (std::size_t place = 0; place < numbers.size(); ++place) {
    const auto key = descending_key<Key>(numbers[place]);
    from[place] = {key, static_cast<std::uint32_t>(place)};
    for (unsigned pass = 0; pass < passes; ++pass) ++counts[pass][digit(key, pass)];
  }
  std::vector<Keyed<Key>> to(numbers.size());
  for (unsigned pass = 0; pass < passes; ++pass) {
    std::array<std::uint32_t, digit_values>& count = counts[pass];
    if (!from.empty() && count[digit(from[0].key, pass)] == from.size()) continue;
    std::uint32_t before = 0;
    for (std::uint32_t& value : count) {
      const std::uint32_t here = value;
      value = before;
      before += here;
    }
    for (const Keyed<Key>& keyed : from) to[count[digit(keyed.key, pass)]++] = keyed;
    from.swap(to);
  }
  std::vector<std::uint32_t> order(numbers.size());
  std::ranges::transform(from, order.begin(), &Keyed<Key>::place);
  return order;
}

}  // namespace

std::vector<std::uint32_t> greatest_first(std::span<const float> numbers) {
  return order_of<std::uint32_t>(numbers);
}

std::vector<std::uint32_t> greatest_first(std::span<const double> numbers) {
  return order_of<std::uint64_t>(numbers);
}

}  // namespace hsr
