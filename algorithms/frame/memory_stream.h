#pragma once

#include <OpenEXR/ImfIO.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace hsr {

/// A file in memory. OpenEXR is not given the real file, as it says nothing when the disk is full
/// at its last write.
class MemoryStream : public Imf::OStream {
 public:
  MemoryStream() : Imf::OStream("memory") {}

  void write(const char bytes[], int count) override {
    const auto size = static_cast<std::size_t>(count);
    content_.resize(std::max(content_.size(), position_ + size));
    std::copy_n(bytes, size, content_.begin() + static_cast<std::ptrdiff_t>(position_));
    position_ += size;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  std::string take_content() { return std::move(content_); }

 private:
  std::string content_;
  std::uint64_t position_ = 0;
};

}  // namespace hsr
