#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/readers/input.h"
#include "scene/scene.h"

namespace hsr {

// The parts of glTF 2.0 (Khronos Group, 2021) that make a scene, as plain data. Every index into
// another array is in range; nothing is known yet about the bytes of the buffers.

/// The type of one number in a buffer, with glTF's codes.
enum class GltfComponent : std::uint16_t {
  int8 = 5120,
  uint8 = 5121,
  int16 = 5122,
  uint16 = 5123,
  uint32 = 5125,
  float32 = 5126
};

struct GltfBuffer {
  std::optional<std::string> uri;  ///< a file or data; without it the bytes are in the GLB file
  std::uint64_t bytes = 0;
};

struct GltfView {
  std::uint32_t buffer = 0;
  std::uint64_t offset = 0;
  std::uint64_t bytes = 0;
  std::uint64_t stride = 0;  ///< from element to element; 0 if these stand close together
};

/// A run of equal elements, or a table of exceptions from one.
struct GltfRun {
  std::uint32_t view = 0;
  std::uint64_t offset = 0;
  GltfComponent component = GltfComponent::float32;
};

struct GltfSparse {
  std::uint64_t count = 0;
  GltfRun indices;
  GltfRun values;
};

struct GltfAccessor {
  std::optional<GltfRun> run;  ///< all zeros without it
  GltfComponent component = GltfComponent::float32;
  std::uint32_t components = 1;  ///< of an element: 1 to 4; 0 for matrices, which are not read
  bool normalized = false;
  std::uint64_t count = 0;
  std::optional<GltfSparse> sparse;
};

struct GltfPrimitive {
  std::optional<std::uint32_t> positions;  ///< an accessor
  std::optional<std::uint32_t> indices;    ///< an accessor
  std::optional<std::uint32_t> material;
  std::uint64_t mode = 4;
};

struct GltfMesh {
  std::vector<GltfPrimitive> primitives;
};

struct GltfNode {
  glm::dmat4 parent_from_node{1.0};
  std::optional<std::uint32_t> mesh;
  std::optional<std::uint32_t> camera;
  std::vector<std::uint32_t> children;
};

struct GltfCamera {
  bool perspective = false;
  double vertical_fov = 0.0;  ///< radians
};

struct GltfModel {
  std::vector<GltfBuffer> buffers;
  std::vector<GltfView> views;
  std::vector<GltfAccessor> accessors;
  std::vector<Material> materials;
  std::vector<GltfMesh> meshes;
  std::vector<GltfCamera> cameras;
  std::vector<GltfNode> nodes;
  std::vector<std::uint32_t> roots;  ///< the nodes that the scene begins with
};

/// Reads the JSON part of a glTF file. Throws InputError on broken JSON (with the byte), on what
/// the specification does not allow (with the path to it), and on required extensions that are not
/// supported (with their names). Warns of what is left out.
GltfModel parse_gltf(const Input& input, std::string_view text);

}  // namespace hsr
