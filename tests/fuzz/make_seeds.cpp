// Writes the seeds that are not text, or that the kit's own writers make: hsr_fuzz_seeds FOLDER, one
// folder below it for each target. The text that was written by hand is in seeds/.

#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>

#include <zlib.h>

#include "scene/catalog.h"
#include "scene/write_scene.h"

namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, std::string_view bytes) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string content(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string word(std::uint32_t value) {
  std::string bytes;
  for (unsigned k = 0; k < 4; ++k) bytes += static_cast<char>(value >> (8 * k) & 0xFFU);
  return bytes;
}

std::string binary_stl(const hsr::Scene& scene) {
  std::string bytes(80, ' ');
  bytes += word(static_cast<std::uint32_t>(scene.triangles.size()));
  for (const hsr::Triangle& triangle : scene.triangles) {
    bytes += std::string(12, '\0');
    for (const std::uint32_t corner : triangle.corners) {
      for (int axis = 0; axis < 3; ++axis) {
        bytes += word(std::bit_cast<std::uint32_t>(scene.positions[corner][axis]));
      }
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

std::string chunk(std::string bytes, std::string_view type, char padding) {
  bytes.resize((bytes.size() + 3) / 4 * 4, padding);
  return word(static_cast<std::uint32_t>(bytes.size())) + std::string(type) + bytes;
}

/// A GLB file of the scene's triangles, without indices.
std::string glb(const hsr::Scene& scene) {
  std::string positions;
  for (const hsr::Triangle& triangle : scene.triangles) {
    for (const std::uint32_t corner : triangle.corners) {
      for (int axis = 0; axis < 3; ++axis) {
        positions += word(std::bit_cast<std::uint32_t>(scene.positions[corner][axis]));
      }
    }
  }
  const std::string size = std::to_string(positions.size());
  const std::string count = std::to_string(3 * scene.triangles.size());
  const std::string json =
      R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"buffers":[{"byteLength":)" +
      size + R"(}],"bufferViews":[{"buffer":0,"byteLength":)" + size +
      R"(}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)" + count + "}]}";
  const std::string chunks = chunk(json, "JSON", ' ') + chunk(positions, std::string_view("BIN\0", 4), '\0');
  return "glTF" + word(2) + word(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

std::string gzip(const std::string& bytes, const fs::path& scratch) {
  const gzFile file = gzopen(scratch.c_str(), "wb");
  (void)gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size()));
  (void)gzclose(file);
  return content(scratch);
}

/// Binary PLY of either order of bytes, by its header's word and a function that lays out 4 bytes.
std::string binary_ply(std::string_view order) {
  const bool is_big = order == "big";
  const auto number = [&](float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    return is_big ? word(__builtin_bswap32(bits)) : word(bits);
  };
  const auto index = [&](std::uint32_t value) {
    return is_big ? word(__builtin_bswap32(value)) : word(value);
  };
  std::string bytes =
      "ply\nformat binary_" + std::string(order) +
      "_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (int k = 0; k < 4; ++k) {
    bytes += number(k == 1 || k == 2 ? 1.0F : 0.0F) + number(k >= 2 ? 1.0F : 0.0F) + number(0.0F) + "\x7F";
  }
  bytes += '\4';
  for (std::uint32_t k = 0; k < 4; ++k) bytes += index(k);
  return bytes;
}

void add_formats(const fs::path& folder, const std::string& words) {
  const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(words);
  const std::string name = words.substr(0, words.find(':'));
  const fs::path scratch = folder / "scratch";
  fs::create_directories(scratch);
  for (const char* kind : {"obj", "ply"}) {
    const fs::path file = scratch / (name + "." + kind);
    hsr::write_scene(*scene, file);
    write(folder / kind / file.filename(), content(file));
  }
  write(folder / "stl" / (name + ".stl"), binary_stl(*scene));
  write(folder / "glb" / (name + ".glb"), glb(*scene));
  fs::remove_all(scratch);
}

/// Every seed so far, plain and compressed, with the byte before it that chooses a file's name.
void add_any_format(const fs::path& folder) {
  for (const char* kind : {"obj", "ply", "off", "stl", "gltf", "glb"}) {
    if (!fs::exists(folder / kind)) continue;
    for (const fs::directory_entry& seed : fs::directory_iterator(folder / kind)) {
      const std::string bytes = content(seed.path());
      if (bytes.size() > 4000) continue;
      const fs::path name = folder / "any_format" / seed.path().filename();
      write(name, std::string(1, '\0') + bytes);
      write(name.string() + ".gz", std::string(1, '\7') + gzip(bytes, folder / "scratch.gz"));
    }
  }
  fs::remove(folder / "scratch.gz");
}

/// Any bytes are a view to the target "render".
void add_views(const fs::path& folder) {
  std::mt19937 random(1972);
  for (int seed = 0; seed < 64; ++seed) {
    std::string bytes(60 + random() % 300, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random() & 0xFFU);
    if (seed % 2 == 0) bytes[8] = '\0';  // a camera that frames the scene
    write(folder / "render" / std::to_string(seed), bytes);
  }
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::cerr << "usage: hsr_fuzz_seeds FOLDER\n";
    return 2;
  }
  const fs::path folder = words[1];
  for (const char* scene : {"cube", "three-bars", "crossing", "glass", "soup:5"}) add_formats(folder, scene);
  for (const char* order : {"little", "big"}) {
    write(folder / "ply" / ("binary_" + std::string(order) + ".ply"), binary_ply(order));
  }
  add_any_format(folder);
  add_views(folder);
}
