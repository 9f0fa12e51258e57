#include "support/read_image.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>

#include <memory>
#include <stdexcept>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

namespace hsr::test {

Picture read_png(const std::filesystem::path& file) {
  Picture picture;
  int channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> bytes(
      stbi_load(file.c_str(), &picture.width, &picture.height, &channels, 0), stbi_image_free);
  if (!bytes) throw std::runtime_error(file.string() + ": " + stbi_failure_reason());
  if (channels != 3) throw std::runtime_error(file.string() + ": not RGB");
  const std::size_t size =
      3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  picture.bytes.assign(bytes.get(), bytes.get() + size);
  return picture;
}

Frame read_exr_layers(const std::filesystem::path& file) {
  Imf::InputFile input(file.c_str());
  const Imath::Box2i window = input.header().dataWindow();
  if (window.min.x != 0 || window.min.y != 0) throw std::runtime_error("the window does not begin at 0, 0");
  Frame frame(window.max.x + 1, window.max.y + 1);

  Imf::FrameBuffer buffer;
  const auto add = [&](const char* name, Imf::PixelType type, void* base, std::size_t stride) {
    const Imf::Channel* channel = input.header().channels().findChannel(name);
    if (channel == nullptr || channel->type != type) throw std::runtime_error(std::string("channel ") + name);
    buffer.insert(name, Imf::Slice(type, static_cast<char*>(base), stride,
                                   stride * static_cast<std::size_t>(frame.width)));
  };
  add("R", Imf::FLOAT, &frame.color.front().r, sizeof(glm::vec4));
  add("G", Imf::FLOAT, &frame.color.front().g, sizeof(glm::vec4));
  add("B", Imf::FLOAT, &frame.color.front().b, sizeof(glm::vec4));
  add("A", Imf::FLOAT, &frame.color.front().a, sizeof(glm::vec4));
  add("Z", Imf::FLOAT, frame.depth.data(), sizeof(float));
  add("id", Imf::UINT, frame.id.data(), sizeof(std::uint32_t));
  input.setFrameBuffer(buffer);
  input.readPixels(0, window.max.y);
  return frame;
}

}  // namespace hsr::test
