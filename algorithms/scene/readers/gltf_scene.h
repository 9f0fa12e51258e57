#pragma once

#include <map>
#include <optional>
#include <vector>

#include "scene/readers/gltf_buffers.h"
#include "scene/readers/gltf_model.h"
#include "scene/readers/input.h"
#include "scene/readers/scene_assembler.h"
#include "scene/scene.h"

namespace hsr {

/// Walks through the nodes of a glTF model, parents before children and children in order, and
/// makes their meshes and cameras a scene.
class GltfSceneBuilder {
 public:
  GltfSceneBuilder(const Input& input, const GltfModel& model, GltfBuffers& buffers);

  Scene build();

 private:
  struct Visit {
    std::uint32_t node;
    glm::dmat4 world_from_parent;
  };
  /// Where in the scene the positions of an accessor begin, for the node at hand.
  using Placed = std::map<std::uint32_t, std::int64_t>;

  void add_mesh(const GltfMesh& mesh, const glm::dmat4& world_from_node);
  void add_primitive(const GltfPrimitive& primitive, const glm::dmat4& world_from_node, Placed& placed);
  std::int64_t place_positions(std::uint32_t accessor, const glm::dmat4& world_from_node, Placed& placed);
  void add_faces(const GltfPrimitive& primitive, const std::vector<std::uint32_t>& indices,
                 std::int64_t first, bool mirrored);
  void spend(std::uint64_t bytes);
  void add_camera(const GltfCamera& camera, const glm::dmat4& world_from_node);
  void aim_camera(Scene& scene) const;

  const Input& input_;
  const GltfModel& model_;
  GltfBuffers& buffers_;
  SceneAssembler assembler_;
  std::optional<Camera> camera_;
  std::vector<std::uint32_t> material_of_scene_;  // by glTF's index; no_material if not used so far
  std::vector<Material> materials_;
  std::uint64_t bytes_ = 0;  // of the scene so far
};

}  // namespace hsr
