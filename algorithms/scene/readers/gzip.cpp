#include "scene/readers/gzip.h"

#include <zlib.h>

#include <algorithm>
#include <cstddef>

#include "scene/errors.h"

namespace hsr {

namespace {

constexpr std::size_t always_allowed = std::size_t{16} << 20U;
constexpr std::size_t greatest_ratio = 100;

/// zlib's state for inflating, ended in every case.
class Inflater {
 public:
  explicit Inflater(std::string_view bytes) : bytes_(bytes) {
    constexpr int gzip_only = 15 + 16;
    if (inflateInit2(&stream_, gzip_only) != Z_OK) {
      throw InputError("not enough memory to inflate gzip data");
    }
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() { (void)inflateEnd(&stream_); }

  std::size_t consumed() const { return consumed_; }

  /// Fills `room` bytes at `target`, or fewer at the end of a member. Returns how many.
  std::size_t inflate_some(char* target, std::size_t room) {
    // zlib counts in unsigned int, and its input is not const by tradition only.
    constexpr std::size_t most = std::size_t{1} << 30U;
    const auto given = static_cast<uInt>(std::min(bytes_.size() - consumed_, most));
    const auto wanted = static_cast<uInt>(std::min(room, most));
    stream_.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes_.data() + consumed_));
    stream_.avail_in = given;
    stream_.next_out = reinterpret_cast<Bytef*>(target);
    stream_.avail_out = wanted;
    const int status = inflate(&stream_, Z_NO_FLUSH);
    consumed_ += given - stream_.avail_in;
    member_ended_ = status == Z_STREAM_END;
    if (status == Z_BUF_ERROR || (status == Z_OK && consumed_ == bytes_.size() && stream_.avail_out > 0)) {
      throw InputError("gzip data is truncated after " + std::to_string(bytes_.size()) + " bytes");
    }
    if (status != Z_OK && status != Z_STREAM_END) {
      throw InputError("gzip data is broken near byte " + std::to_string(consumed_) +
                       (stream_.msg != nullptr ? std::string(": ") + stream_.msg : std::string()));
    }
    return wanted - stream_.avail_out;
  }

  /// Whether the last member is done. What follows it, if that is not a further member, is padding.
  bool is_done() {
    if (member_ended_ && is_gzip(bytes_.substr(consumed_))) {
      member_ended_ = false;
      (void)inflateReset(&stream_);
    }
    return member_ended_;
  }

 private:
  std::string_view bytes_;
  std::size_t consumed_ = 0;
  bool member_ended_ = false;
  z_stream stream_{};
};

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1F\x8B"); }

std::string inflate_gzip(std::string_view bytes, const Progress& progress) {
  const std::size_t limit = std::max(always_allowed, greatest_ratio * bytes.size());
  Inflater inflater(bytes);
  std::string result;
  std::size_t filled = 0;
  do {
    if (filled == result.size()) {
      // Usual meshes shrink to a quarter; afterwards growth by halves keeps the peak low.
      result.resize(std::min(std::max(4 * bytes.size(), filled + filled / 2) + 4096, limit + 1));
      const double part = static_cast<double>(inflater.consumed()) / static_cast<double>(bytes.size());
      if (!report_progress(progress, "inflating", part)) {
        throw InputError("interrupted");
      }
    }
    filled += inflater.inflate_some(result.data() + filled, result.size() - filled);
    if (filled > limit) {
      throw InputError("refused: gzip data inflates to more than " + std::to_string(greatest_ratio) +
                       " times its size");
    }
  } while (!inflater.is_done());
  result.resize(filled);
  return result;
}

}  // namespace hsr
