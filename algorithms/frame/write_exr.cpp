#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>

#include "frame/memory_stream.h"
#include "frame/write_image.h"
#include "scene/atomic_file.h"
#include "scene/errors.h"

namespace hsr {
namespace {

constexpr int rows_at_once = 64;  // a multiple of the 16 that ZIP compresses together

/// One channel of the file: values of `type` that begin at `base` and lie `stride` bytes apart.
void add_channel(Imf::Header& header, Imf::FrameBuffer& buffer, const char* name, Imf::PixelType type,
                 const void* base, std::size_t stride, int width) {
  header.channels().insert(name, Imf::Channel(type));
  // OpenEXR reads and writes through the same kind of pointer; here it only reads.
  char* first = static_cast<char*>(const_cast<void*>(base));
  buffer.insert(name, Imf::Slice(type, first, stride, stride * static_cast<std::size_t>(width)));
}

std::string encode(const Frame& frame, const Progress& progress) {
  Imf::Header header(frame.width, frame.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::FrameBuffer buffer;
  const float* color = &frame.color.front().r;
  add_channel(header, buffer, "R", Imf::FLOAT, color, sizeof(glm::vec4), frame.width);
  add_channel(header, buffer, "G", Imf::FLOAT, color + 1, sizeof(glm::vec4), frame.width);
  add_channel(header, buffer, "B", Imf::FLOAT, color + 2, sizeof(glm::vec4), frame.width);
  add_channel(header, buffer, "A", Imf::FLOAT, color + 3, sizeof(glm::vec4), frame.width);
  add_channel(header, buffer, "Z", Imf::FLOAT, frame.depth.data(), sizeof(float), frame.width);
  add_channel(header, buffer, "id", Imf::UINT, frame.id.data(), sizeof(std::uint32_t), frame.width);

  MemoryStream stream;
  {
    Imf::OutputFile output(stream, header);
    output.setFrameBuffer(buffer);
    for (int done = 0; done < frame.height;) {
      const int rows = std::min(rows_at_once, frame.height - done);
      output.writePixels(rows);
      done += rows;
      (void)report_progress(progress, "writing the layers", static_cast<double>(done) / frame.height);
    }
  }  // the table of lines is written here
  return stream.take_content();
}

}  // namespace

void write_exr_layers(const Frame& frame, const std::filesystem::path& file, const Progress& progress) {
  write_file_atomically(file, [&](const std::filesystem::path& temporary) {
    std::string content;
    try {
      content = encode(frame, progress);
    } catch (const std::exception& failure) {
      throw InputError("cannot write " + file.string() + ": " + failure.what());
    }
    write_bytes(temporary, content);
  });
}

}  // namespace hsr
