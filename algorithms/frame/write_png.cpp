#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "frame/srgb.h"
#include "frame/write_image.h"
#include "scene/atomic_file.h"

namespace hsr {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::string big_endian(std::uint32_t number) {
  std::string text;
  for (const int shift : {24, 16, 8, 0}) text += static_cast<char>((number >> shift) & 255U);
  return text;
}

/// A chunk of a PNG file (Portable Network Graphics specification, second edition, section 5.3):
/// length, type, data, and a checksum over type and data.
void write_chunk(OutputFile& file, std::string_view type, std::string_view data) {
  const std::string body = std::string(type) + std::string(data);
  const uLong checksum =
      crc32_z(crc32_z(0, nullptr, 0), reinterpret_cast<const Bytef*>(body.data()), body.size());
  file.write(big_endian(static_cast<std::uint32_t>(data.size())) + body +
             big_endian(static_cast<std::uint32_t>(checksum)));
}

/// Compresses what it is given into IDAT chunks of bounded size, so that no picture is too large.
class ImageData {
 public:
  explicit ImageData(OutputFile& file) : file_(file), compressed_(std::size_t{1} << 16U, '\0') {
    if (deflateInit2(&stream_, compression_level, Z_DEFLATED, MAX_WBITS, MAX_MEM_LEVEL, Z_FILTERED) != Z_OK) {
      throw std::bad_alloc();
    }
    empty_buffer();
  }
  ImageData(const ImageData&) = delete;
  ImageData& operator=(const ImageData&) = delete;
  ~ImageData() { (void)deflateEnd(&stream_); }

  void write(Bytes& bytes) {
    stream_.next_in = bytes.data();
    stream_.avail_in = static_cast<uInt>(bytes.size());
    while (stream_.avail_in > 0) {
      (void)deflate(&stream_, Z_NO_FLUSH);
      if (stream_.avail_out == 0) write_buffer();
    }
  }

  void finish() {
    while (deflate(&stream_, Z_FINISH) != Z_STREAM_END) write_buffer();
    write_buffer();
  }

 private:
  static constexpr int compression_level = 6;

  void empty_buffer() {
    stream_.next_out = reinterpret_cast<Bytef*>(compressed_.data());
    stream_.avail_out = static_cast<uInt>(compressed_.size());
  }
  void write_buffer() {
    write_chunk(file_, "IDAT",
                std::string_view(compressed_).substr(0, compressed_.size() - stream_.avail_out));
    empty_buffer();
  }

  OutputFile& file_;
  std::string compressed_;
  z_stream stream_{};
};

/// A byte from its neighbours to the left, above and above left (same specification, section 9.4).
int paeth_predictor(int left, int above, int above_left) {
  const int estimate = left + above - above_left;
  const int to_left = std::abs(estimate - left);
  const int to_above = std::abs(estimate - above);
  const int to_above_left = std::abs(estimate - above_left);
  if (to_left <= to_above && to_left <= to_above_left) return left;
  return to_above <= to_above_left ? above : above_left;
}

/// Leaves in `filtered` the number of the filter and the row's differences from what `predict` makes
/// of the bytes to the left, above and above left. Both rows begin with a black pixel that stands for
/// what is left of the picture.
template <typename Predict>
void apply(int filter, const Predict& predict, const Bytes& row, const Bytes& above, Bytes& filtered) {
  filtered[0] = static_cast<std::uint8_t>(filter);
  for (std::size_t k = 3; k < row.size(); ++k) {
    filtered[k - 2] = static_cast<std::uint8_t>(row[k] - predict(row[k - 3], above[k], above[k - 3]));
  }
}

/// Filter 0 to 4 of the specification.
void apply_filter(int filter, const Bytes& row, const Bytes& above, Bytes& filtered) {
  switch (filter) {
    case 1:
      return apply(
          filter, [](int left, int, int) { return left; }, row, above, filtered);
    case 2:
      return apply(
          filter, [](int, int up, int) { return up; }, row, above, filtered);
    case 3:
      return apply(
          filter, [](int left, int up, int) { return (left + up) / 2; }, row, above, filtered);
    case 4:
      return apply(filter, paeth_predictor, row, above, filtered);
    default:
      return apply(
          filter, [](int, int, int) { return 0; }, row, above, filtered);
  }
}

/// The usual guess at how badly a filtered row will compress: the sum of its differences' sizes.
std::uint64_t difference_sum(const Bytes& filtered) {
  std::uint64_t sum = 0;
  for (std::size_t k = 1; k < filtered.size(); ++k) {
    sum += std::min<std::uint8_t>(filtered[k], static_cast<std::uint8_t>(-filtered[k]));
  }
  return sum;
}

/// Leaves in `best` the filtered row with the least sum of differences.
void apply_best_filter(const Bytes& row, const Bytes& above, Bytes& best, Bytes& scratch) {
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  for (int filter = 0; filter <= 4; ++filter) {
    apply_filter(filter, row, above, scratch);
    const std::uint64_t sum = difference_sum(scratch);
    if (sum < least) {
      least = sum;
      std::swap(best, scratch);
    }
  }
}

/// Row j over the backdrop, three bytes a pixel, after one black pixel.
void encode_row(const Frame& frame, int j, const glm::vec3& backdrop, Bytes& row) {
  std::size_t byte = 3;
  for (int i = 0; i < frame.width; ++i) {
    const glm::vec4& color = frame.color[frame.index(i, j)];
    const double shine_through = 1.0 - static_cast<double>(color.a);
    for (int channel = 0; channel < 3; ++channel) {
      row[byte++] = srgb8_from_linear(static_cast<double>(color[channel]) +
                                      shine_through * static_cast<double>(backdrop[channel]));
    }
  }
}

void write_picture(const Frame& frame, const glm::vec3& backdrop, OutputFile& file,
                   const Progress& progress) {
  file.write("\x89PNG\r\n\x1a\n");
  const std::string eight_bit_rgb("\x08\x02\x00\x00\x00", 5);
  write_chunk(file, "IHDR",
              big_endian(static_cast<std::uint32_t>(frame.width)) +
                  big_endian(static_cast<std::uint32_t>(frame.height)) + eight_bit_rgb);
  write_chunk(file, "sRGB", std::string(1, '\0'));

  const std::size_t row_bytes = 3 * static_cast<std::size_t>(frame.width);
  Bytes row(3 + row_bytes);
  Bytes above(3 + row_bytes);
  Bytes filtered(1 + row_bytes);
  Bytes scratch(1 + row_bytes);
  ImageData data(file);
  for (int j = 0; j < frame.height; ++j) {
    encode_row(frame, j, backdrop, row);
    apply_best_filter(row, above, filtered, scratch);
    data.write(filtered);
    std::swap(row, above);
    (void)report_progress(progress, "writing the picture", (j + 1.0) / frame.height);
  }
  data.finish();
  write_chunk(file, "IEND", {});
}

}  // namespace

void write_png(const Frame& frame, const glm::vec3& backdrop, const std::filesystem::path& file,
               const Progress& progress) {
  write_file_atomically(file, [&](const std::filesystem::path& temporary) {
    OutputFile output(temporary);
    write_picture(frame, backdrop, output, progress);
    output.close();
  });
}

}  // namespace hsr
