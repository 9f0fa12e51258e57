#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "frame/frame.h"
#include "frame/gif_palette.h"
#include "predicates/pixel_box.h"

namespace hsr {

/// Writes an animation, picture by picture, as a GIF that is played again and again. Meant for use
/// within write_file_atomically. Every failure throws InputError with the file's name.
class GifWriter {
 public:
  /// `window` is the part of the pictures that is shown; each of its pixels becomes `scale` × `scale`
  /// pixels. Both sides of what is shown are at most 65535 pixels.
  GifWriter(const std::filesystem::path& file, const PixelBox& window, int scale, const GifPalette& palette,
            const glm::vec3& backdrop);
  ~GifWriter();
  GifWriter(const GifWriter&) = delete;
  GifWriter& operator=(const GifWriter&) = delete;

  /// Adds a picture, shown for `hundredths` of a second. It differs from the last one within `changed`
  /// alone, which is not looked at for the first.
  void add(const Frame& frame, PixelBox changed, int hundredths);

  /// Must be called before the end.
  void finish();

 private:
  class Stream;

  PixelBox window_;
  int scale_;
  GifPalette palette_;
  glm::vec3 backdrop_;
  bool first_ = true;
  std::unique_ptr<Stream> stream_;
};

}  // namespace hsr
