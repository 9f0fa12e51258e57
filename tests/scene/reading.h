#pragma once

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/errors.h"
#include "scene/read_scene.h"
#include "support/temporary_folder.h"

namespace hsr::test {

/// What came of reading a file: a scene with warnings, or an error. Messages are without the folder.
struct Reading {
  Scene scene;
  std::vector<std::string> warnings;
  std::string error;
};

inline std::string without_folder(std::string message, const TemporaryFolder& folder) {
  const std::string prefix = folder.path().string() + "/";
  for (std::size_t at = message.find(prefix); at != std::string::npos; at = message.find(prefix)) {
    message.erase(at, prefix.size());
  }
  return message;
}

/// Reads a file of the folder.
inline Reading read_file(const TemporaryFolder& folder, std::string_view name) {
  Reading reading;
  try {
    ReadReport report;
    reading.scene = read_scene(folder / name, report);
    for (const std::string& warning : report.warnings) {
      reading.warnings.push_back(without_folder(warning, folder));
    }
  } catch (const InputError& error) {
    reading.error = without_folder(error.what(), folder);
  }
  return reading;
}

/// Reads a file that is made for it, alone in a folder.
inline Reading read_text(std::string_view name, std::string_view content) {
  const TemporaryFolder folder;
  folder.write(name, content);
  return read_file(folder, name);
}

/// The corners of every triangle, as indices.
inline std::vector<std::array<std::uint32_t, 3>> corners(const Scene& scene) {
  std::vector<std::array<std::uint32_t, 3>> result;
  for (const Triangle& triangle : scene.triangles) {
    result.push_back(triangle.corners);
  }
  return result;
}

/// The face of every triangle.
inline std::vector<std::uint32_t> faces(const Scene& scene) {
  std::vector<std::uint32_t> result;
  for (const Triangle& triangle : scene.triangles) {
    result.push_back(triangle.face);
  }
  return result;
}

using Corners = std::vector<std::array<std::uint32_t, 3>>;
using Faces = std::vector<std::uint32_t>;
using Lines = std::vector<std::string>;

}  // namespace hsr::test

namespace doctest {

template <>
struct StringMaker<hsr::test::Lines> {
  static String convert(const hsr::test::Lines& lines) {
    std::string text;
    for (const std::string& line : lines) {
      text += "\n    " + line;
    }
    return text.c_str();
  }
};

}  // namespace doctest
