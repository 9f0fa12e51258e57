#include "scene/readers/gltf_buffers.h"
#include "scene/readers/gltf_model.h"
#include "scene/readers/gltf_scene.h"
#include "scene/readers/readers.h"

namespace hsr {

namespace {

Scene build(const Input& input, std::string_view json, std::string_view binary) {
  const GltfModel model = parse_gltf(input, json);
  GltfBuffers buffers(input, model, binary);
  return GltfSceneBuilder(input, model, buffers).build();
}

/// A whole number of four bytes, little-endian, at `offset`; the caller knows that it is there.
std::uint32_t word_at(std::string_view bytes, std::size_t offset) {
  std::uint32_t value = 0;
  for (unsigned k = 0; k < 4; ++k) {
    value |= std::uint32_t{static_cast<unsigned char>(bytes[offset + k])} << (8 * k);
  }
  return value;
}

}  // namespace

Scene read_gltf(const Input& input) { return build(input, input.bytes, {}); }

Scene read_glb(const Input& input) {
  constexpr std::size_t header = 12;  // "glTF", version, length of all
  constexpr std::uint32_t json_type = 0x4E4F534A;
  constexpr std::uint32_t binary_type = 0x004E4942;
  if (input.bytes.size() < header) {
    input.fail({}, "truncated: the file ends within the GLB header");
  }
  const std::uint32_t version = word_at(input.bytes, 4);
  if (version != 2) {
    input.fail(Place::byte(4), "GLB version " + std::to_string(version) + ": only 2 is supported");
  }
  const std::uint32_t length = word_at(input.bytes, 8);
  if (length > input.bytes.size()) {
    input.fail({}, "truncated: the file ends after " + std::to_string(input.bytes.size()) + " of " +
                       counted(length, "byte", "bytes"));
  }
  std::string_view json;
  std::string_view binary;
  for (std::size_t at = header; at < length;) {
    if (length - at < 8 || word_at(input.bytes, at) > length - at - 8) {
      input.fail(Place::byte(at), "truncated: this chunk ends after the file");
    }
    const std::uint32_t size = word_at(input.bytes, at);
    const std::uint32_t type = word_at(input.bytes, at + 4);
    const std::string_view chunk = input.bytes.substr(at + 8, size);
    if (type == json_type && json.data() == nullptr) {
      json = chunk;
    } else if (type == binary_type && binary.data() == nullptr) {
      binary = chunk;
    }
    at += 8 + size;
  }
  if (json.data() == nullptr) {
    input.fail({}, "the GLB file has no JSON chunk");
  }
  return build(input, json, binary);
}

}  // namespace hsr
