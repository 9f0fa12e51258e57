#include "frame/deep_image.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>  // so that the linter tells its OutputFile from ours
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>

#include "frame/memory_stream.h"
#include "scene/atomic_file.h"
#include "scene/errors.h"

namespace hsr {

namespace {

constexpr std::array<const char*, 5> float_channels = {"R", "G", "B", "A", "Z"};

Imf::Header deep_header(int width, int height) {
  Imf::Header header(width, height);
  header.setType(Imf::DEEPSCANLINE);
  header.compression() = Imf::ZIPS_COMPRESSION;
  for (const char* name : float_channels) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
  header.channels().insert("id", Imf::Channel(Imf::UINT));
  Imf::addComments(
      header,
      "Z is eye depth, id the number of the triangle. Samples stand in exact order of depth; one "
      "with A = 0 may be at exactly the same depth as that before it, which counts for both.");
  return header;
}

// Turns what OpenEXR throws into an error of ours.
template <class Work>
void encode(Work work) {
  try {
    work();
  } catch (const std::exception& failure) {
    throw InputError(std::string("cannot make the deep image: ") + failure.what());
  }
}

}  // namespace

// OpenEXR reads a row at a time, by pointers to each pixel's first value of each channel.
struct DeepImage::Encoder {
  Encoder(int image_width, int image_height, const std::vector<glm::vec4>& surface)
      : width(static_cast<std::size_t>(image_width)),
        colors(surface),
        counts(width),
        id_of_pixel(width),
        file(std::make_unique<Imf::DeepScanLineOutputFile>(stream, deep_header(image_width, image_height))) {
    for (auto& pointers : floats_of_pixel) pointers.resize(width);
    // A stride of 0 from row to row: every row is found in the same place.
    Imf::DeepFrameBuffer buffer;
    buffer.insertSampleCountSlice(Imf::Slice(Imf::UINT, bytes_of(counts.data()), sizeof(counts.front()), 0));
    for (std::size_t k = 0; k < float_channels.size(); ++k) {
      buffer.insert(float_channels[k], Imf::DeepSlice(Imf::FLOAT, bytes_of(floats_of_pixel[k].data()),
                                                      sizeof(float*), 0, sizeof(float)));
    }
    buffer.insert("id", Imf::DeepSlice(Imf::UINT, bytes_of(id_of_pixel.data()), sizeof(unsigned*), 0,
                                       sizeof(unsigned)));
    file->setFrameBuffer(buffer);
  }

  template <class T>
  static char* bytes_of(T* values) {
    return reinterpret_cast<char*>(values);
  }

  void add_row(const FragmentLists& lists, std::size_t first_pixel) {
    const std::size_t begin = lists.begin[first_pixel];
    const std::size_t count = lists.begin[first_pixel + width] - begin;
    for (auto& values : floats) values.resize(count);
    ids.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
      const ListFragment& fragment = lists.fragments[begin + k];
      const glm::vec4 color = fragment.tied ? glm::vec4(0.0F) : colors[fragment.id];
      for (std::size_t channel = 0; channel < 4; ++channel) {
        floats[channel][k] = color[static_cast<glm::length_t>(channel)];
      }
      floats[4][k] = fragment.depth;
      ids[k] = fragment.id;
    }
    for (std::size_t column = 0; column < width; ++column) {
      const std::size_t at = lists.begin[first_pixel + column] - begin;
      counts[column] = static_cast<unsigned>(lists.begin[first_pixel + column + 1] - begin - at);
      for (std::size_t k = 0; k < floats.size(); ++k) floats_of_pixel[k][column] = floats[k].data() + at;
      id_of_pixel[column] = ids.data() + at;
    }
    file->writePixels(1);
  }

  std::size_t width;
  const std::vector<glm::vec4>& colors;
  std::array<std::vector<float>, float_channels.size()> floats;  // of a row
  std::vector<unsigned> ids;
  std::vector<unsigned> counts;  // per pixel
  std::array<std::vector<float*>, float_channels.size()> floats_of_pixel;
  std::vector<unsigned*> id_of_pixel;
  MemoryStream stream;
  std::unique_ptr<Imf::DeepScanLineOutputFile> file;
};

DeepImage::DeepImage(int width, int height, const std::vector<glm::vec4>& colors) {
  encode([&] { encoder_ = std::make_unique<Encoder>(width, height, colors); });
}

DeepImage::~DeepImage() = default;

void DeepImage::add_rows(const FragmentLists& lists, int first, int rows) {
  encode([&] {
    for (int row = first; row < first + rows; ++row) {
      encoder_->add_row(lists, static_cast<std::size_t>(row) * encoder_->width);
    }
  });
}

void DeepImage::write(const std::filesystem::path& file) {
  assert(encoder_->file);
  encode([&] { encoder_->file.reset(); });  // the table of rows is written here
  const std::string content = encoder_->stream.take_content();
  write_file_atomically(file,
                        [&](const std::filesystem::path& temporary) { write_bytes(temporary, content); });
}

}  // namespace hsr
