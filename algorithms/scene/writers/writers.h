#pragma once

#include <cstddef>
#include <filesystem>

#include "scene/progress.h"
#include "scene/scene.h"

namespace hsr {

/// Tells how many of a file's rows are written. Throws InputError when the listener asks to stop.
class RowProgress {
 public:
  RowProgress(const Scene& scene, const Progress& progress)
      : rows_(scene.positions.size() + scene.triangles.size()), progress_(progress) {}

  /// To be called before each row.
  void next() {
    constexpr std::size_t rows_per_report = 65536;  // some milliseconds' work
    if (written_++ % rows_per_report == 0) report();
  }

 private:
  void report() const;

  std::size_t rows_;
  std::size_t written_ = 0;
  const Progress& progress_;
};

/// Writes a Wavefront OBJ file: every position with nine significant digits at most, which read
/// back as the same float32, and every triangle in id order. If the scene has materials, they go to
/// an MTL file of the same name beside it (not beside a pipe or device). Throws InputError.
void write_obj(const Scene& scene, const std::filesystem::path& file, const Progress& progress);

/// Writes a binary little-endian PLY file: positions and triangles, bit for bit. It has no place
/// for materials. Throws InputError.
void write_ply(const Scene& scene, const std::filesystem::path& file, const Progress& progress);

}  // namespace hsr
