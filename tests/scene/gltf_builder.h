#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/bytes.h"

namespace hsr::test {

/// Bytes as base64, for data URIs.
inline std::string base64(std::string_view bytes) {
  static constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits * 256 + (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? digits[(bits >> (18 - 6 * k)) & 63U] : '=';
    }
  }
  return text;
}

/// A glTF file in the making: one buffer, to which accessors are added, and the JSON about it.
class GltfBuilder {
 public:
  GltfBuilder() { json["asset"]["version"] = "2.0"; }

  nlohmann::json json;

  /// Adds an accessor with its own view. Returns its index.
  template <class Number>
  std::size_t add(const std::vector<Number>& numbers, int component_type, std::string_view type) {
    const std::size_t start = buffer_.size();
    for (const Number number : numbers) {
      buffer_ += bytes_of(number);
    }
    const std::size_t size = buffer_.size() - start;
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", start}, {"byteLength", size}});
    buffer_.resize((buffer_.size() + 3) / 4 * 4);
    const std::size_t width = type == "VEC3" ? 3 : 1;
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", component_type},
                                 {"count", numbers.size() / width},
                                 {"type", type}});
    return json["accessors"].size() - 1;
  }

  /// Adds a mesh of one primitive and a node that shows it, in the default scene.
  nlohmann::json& add_mesh(const nlohmann::json& primitive) {
    json["meshes"].push_back({{"primitives", {primitive}}});
    json["nodes"].push_back({{"mesh", json["meshes"].size() - 1}});
    json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
    return json["nodes"].back();
  }

  /// The file as JSON with the buffer within it.
  std::string gltf() const {
    nlohmann::json whole = json;
    whole["buffers"] = {
        {{"byteLength", buffer_.size()}, {"uri", "data:application/octet-stream;base64," + base64(buffer_)}}};
    return whole.dump();
  }

  /// The file as JSON with the buffer in another file.
  std::string gltf_with_buffer_file(const std::string& uri) const {
    nlohmann::json whole = json;
    whole["buffers"] = {{{"byteLength", buffer_.size()}, {"uri", uri}}};
    return whole.dump();
  }

  std::string glb() const {
    nlohmann::json whole = json;
    whole["buffers"] = {{{"byteLength", buffer_.size()}}};
    std::string text = whole.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const auto size = [](std::size_t bytes) { return bytes_of(static_cast<std::uint32_t>(bytes)); };
    return "glTF" + size(2) + size(12 + 8 + text.size() + 8 + buffer_.size()) + size(text.size()) + "JSON" +
           text + size(buffer_.size()) + std::string("BIN\0", 4) + buffer_;
  }

  const std::string& buffer() const { return buffer_; }

 private:
  std::string buffer_;
};

}  // namespace hsr::test
