#pragma once

#include <cstddef>
#include <cstring>
#include <string_view>

namespace hsr::fuzz {

/// Takes bytes from the front of a fuzzer's input; zeros when there are none left.
class ByteSource {
 public:
  explicit ByteSource(std::string_view bytes) : bytes_(bytes) {}

  std::size_t left() const { return bytes_.size(); }

  unsigned byte() { return take<unsigned char>(); }

  /// The next bits of the input as they are: any float, double or integer there is.
  template <class Value>
  Value take() {
    Value value{};
    const std::size_t count = bytes_.size() < sizeof value ? bytes_.size() : sizeof value;
    if (count > 0) std::memcpy(&value, bytes_.data(), count);
    bytes_.remove_prefix(count);
    return value;
  }

 private:
  std::string_view bytes_;
};

}  // namespace hsr::fuzz
