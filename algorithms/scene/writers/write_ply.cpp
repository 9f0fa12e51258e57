#include <bit>
#include <cstdint>
#include <string>

#include "scene/atomic_file.h"
#include "scene/writers/writers.h"

namespace hsr {

namespace {

void append_little_endian(std::string& bytes, std::uint32_t value) {
  for (unsigned shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>((value >> shift) & 0xFFU);
  }
}

std::string header(const Scene& scene) {
  return "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(scene.positions.size()) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         std::to_string(scene.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

}  // namespace

void write_ply(const Scene& scene, const std::filesystem::path& file, const Progress& progress) {
  write_file_atomically(file, [&](const std::filesystem::path& temporary) {
    OutputFile output(temporary);
    output.write(header(scene));
    RowProgress rows(scene, progress);
    std::string row;
    for (const glm::vec3& position : scene.positions) {
      rows.next();
      row.clear();
      for (int k = 0; k < 3; ++k) {
        append_little_endian(row, std::bit_cast<std::uint32_t>(position[k]));
      }
      output.write(row);
    }
    for (const Triangle& triangle : scene.triangles) {
      rows.next();
      row.assign(1, '\3');
      for (const std::uint32_t corner : triangle.corners) {
        append_little_endian(row, corner);
      }
      output.write(row);
    }
    output.close();
  });
}

}  // namespace hsr
