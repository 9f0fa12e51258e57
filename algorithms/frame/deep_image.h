#pragma once

#include <filesystem>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

#include "frame/fragment_lists.h"

namespace hsr {

/// An OpenEXR deep scan line image of depth lists: for each fragment R, G, B, A (FLOAT, linear,
/// premultiplied), Z (FLOAT, eye depth) and id (UINT), ZIPS compressed. A pixel's samples stand in the
/// exact order of depth, though neighbours may have the same Z, which is rounded.
///
/// A fragment at exactly the same depth as the one before it is there with its id and Z, but with R, G, B
/// and A of 0: such fragments count once in the colour, and readers blend each sample that they find. So the
/// samples flattened are what the lists composited are, and still no surface is missing.
class DeepImage {
 public:
  /// `colors` are premultiplied, by id, and must outlive the object. Throws InputError.
  DeepImage(int width, int height, const std::vector<glm::vec4>& colors);
  ~DeepImage();
  DeepImage(const DeepImage&) = delete;
  DeepImage& operator=(const DeepImage&) = delete;

  /// Adds the next `rows` rows of the picture, the first of which is `first`. `lists` are those of the whole
  /// picture, of which only these rows are looked at. Throws InputError.
  void add_rows(const FragmentLists& lists, int first, int rows);

  /// Writes the file when all rows were added. Throws InputError and leaves nothing half-written.
  void write(const std::filesystem::path& file);

 private:
  struct Encoder;
  std::unique_ptr<Encoder> encoder_;
};

}  // namespace hsr
