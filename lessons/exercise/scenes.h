#pragma once

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

/// The scenes that the program hsr made for an exercise on whole pictures, with the exact answers. The file
/// is written by viewer/exercise/scene_data.cpp: numbers as they lie in memory.
namespace check {

class Bytes {
 public:
  explicit Bytes(const std::string& name) : file_(std::fopen(name.c_str(), "rb")) {
    if (file_ == nullptr) throw std::runtime_error("cannot read " + name);
  }
  Bytes(const Bytes&) = delete;
  Bytes& operator=(const Bytes&) = delete;
  ~Bytes() { std::fclose(file_); }

  template <class Number>
  Number take() {
    Number number{};
    take_all(&number, sizeof number);
    return number;
  }
  template <class Number>
  std::vector<Number> take_vector(std::size_t count) {
    std::vector<Number> numbers(count);
    take_all(numbers.data(), count * sizeof(Number));
    return numbers;
  }
  std::string take_text() {
    const std::vector<char> letters = take_vector<char>(take<std::uint32_t>());
    return {letters.begin(), letters.end()};
  }

 private:
  void take_all(void* place, std::size_t bytes) {
    if (bytes > 0 && std::fread(place, 1, bytes, file_) != bytes)
      throw std::runtime_error("the scenes are cut off");
  }
  std::FILE* file_;
};

/// A view of a scene. `Triangle` is the exercise's own, made of nine floats and a colour of four.
struct SceneData {
  std::string name;
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::vector<double> clip_from_world;  ///< 16, row by row
  std::vector<double> eye;              ///< 3
  double near_depth = 0.0;
  double far_depth = 0.0;
  std::vector<float> positions;  ///< 9 for each triangle: three corners in the world
  std::vector<float> colors;     ///< 4 for each triangle: linear, premultiplied, and opacity
  /// The exact answer, where it was asked for: id and depth of each pixel, and whether there is a tie.
  std::vector<std::uint32_t> id;
  std::vector<double> depth;
  std::vector<std::uint8_t> tied;
};

inline std::vector<SceneData> read_scenes(const std::string& name) {
  Bytes bytes(name);
  std::vector<SceneData> scenes(bytes.take<std::uint32_t>());
  for (SceneData& scene : scenes) {
    scene.name = bytes.take_text();
    scene.width = bytes.take<std::int32_t>();
    scene.height = bytes.take<std::int32_t>();
    scene.clip_from_world = bytes.take_vector<double>(16);
    scene.eye = bytes.take_vector<double>(3);
    scene.near_depth = bytes.take<double>();
    scene.far_depth = bytes.take<double>();
    const auto triangles = bytes.take<std::uint32_t>();
    scene.positions = bytes.take_vector<float>(9 * std::size_t{triangles});
    scene.colors = bytes.take_vector<float>(4 * std::size_t{triangles});
    const auto answers = bytes.take<std::uint32_t>();
    scene.id = bytes.take_vector<std::uint32_t>(answers);
    scene.depth = bytes.take_vector<double>(answers);
    scene.tied = bytes.take_vector<std::uint8_t>(answers);
  }
  return scenes;
}

/// Writes one section of a picture's stream (algorithms/trace/picture_stream.h).
template <class Number>
void write_section(std::FILE* stream, const char* name, const std::vector<Number>& numbers) {
  std::fprintf(stream, "%s %zu\n", name, numbers.size() * sizeof(Number));
  std::fwrite(numbers.data(), sizeof(Number), numbers.size(), stream);
}

}  // namespace check
