#include "scene/readers/gltf_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <numeric>

#include "scene/readers/numbers.h"

namespace hsr {

namespace {

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// How the corners of a primitive make triangles, with glTF's numbers.
constexpr std::uint64_t triangle_list = 4;
constexpr std::uint64_t triangle_strip = 5;
constexpr std::uint64_t triangle_fan = 6;

/// The corners of triangle i of a primitive, as places in its list of corners; order as in the
/// specification, section 3.7.2.1.
std::array<std::size_t, 3> corners_of(std::uint64_t mode, std::size_t i) {
  if (mode == triangle_strip) {
    return {i, i + 1 + i % 2, i + 2 - i % 2};
  }
  if (mode == triangle_fan) {
    return {i + 1, i + 2, 0};
  }
  return {3 * i, 3 * i + 1, 3 * i + 2};
}

std::size_t triangle_count(std::uint64_t mode, std::size_t corners) {
  return mode == triangle_list ? corners / 3 : corners < 3 ? 0 : corners - 2;
}

}  // namespace

GltfSceneBuilder::GltfSceneBuilder(const Input& input, const GltfModel& model, GltfBuffers& buffers)
    : input_(input),
      model_(model),
      buffers_(buffers),
      assembler_(input.warnings, 0),
      material_of_scene_(model.materials.size(), no_material) {}

Scene GltfSceneBuilder::build() {
  std::vector<Visit> to_visit;
  std::vector<bool> visited(model_.nodes.size(), false);
  const auto push = [&](const std::vector<std::uint32_t>& nodes, const glm::dmat4& world_from_parent) {
    for (std::size_t i = nodes.size(); i-- > 0;) {  // backwards, as the last one is visited first
      to_visit.push_back({nodes[i], world_from_parent});
    }
  };
  push(model_.roots, glm::dmat4(1.0));
  while (!to_visit.empty()) {
    const Visit visit = to_visit.back();
    to_visit.pop_back();
    if (visited[visit.node]) {
      input_.fail({}, "nodes[" + std::to_string(visit.node) + "] is reached twice: nodes must form a tree");
    }
    visited[visit.node] = true;
    const GltfNode& node = model_.nodes[visit.node];
    const glm::dmat4 world_from_node = visit.world_from_parent * node.parent_from_node;
    if (node.mesh) {
      add_mesh(model_.meshes[*node.mesh], world_from_node);
    }
    if (node.camera) {
      add_camera(model_.cameras[*node.camera], world_from_node);
    }
    push(node.children, world_from_node);
  }
  Scene scene = assembler_.finish();
  scene.materials = std::move(materials_);
  aim_camera(scene);
  return scene;
}

void GltfSceneBuilder::add_mesh(const GltfMesh& mesh, const glm::dmat4& world_from_node) {
  Placed placed;
  for (const GltfPrimitive& primitive : mesh.primitives) {
    add_primitive(primitive, world_from_node, placed);
  }
}

void GltfSceneBuilder::add_primitive(const GltfPrimitive& primitive, const glm::dmat4& world_from_node,
                                     Placed& placed) {
  if (primitive.mode < triangle_list) {
    input_.warnings.add("", {}, [] { return std::string("points and lines are left out"); });
    return;
  }
  if (primitive.mode > triangle_fan) {
    input_.fail({}, "a primitive has the unknown mode " + std::to_string(primitive.mode));
  }
  if (!primitive.positions) {
    input_.warnings.add("", {}, [] { return std::string("a primitive without POSITION is left out"); });
    return;
  }
  const std::int64_t first = place_positions(*primitive.positions, world_from_node, placed);
  std::vector<std::uint32_t> indices;
  if (primitive.indices) {
    indices = buffers_.indices(*primitive.indices);
  } else {
    indices.resize(model_.accessors[*primitive.positions].count);
    std::iota(indices.begin(), indices.end(), 0U);
  }
  // A transform that mirrors turns every triangle round; glTF means its front to stay the front.
  const bool mirrored = glm::determinant(glm::dmat3(world_from_node)) < 0;
  add_faces(primitive, indices, first, mirrored);
}

/// Adds the positions of an accessor, moved to the world, unless this node has done so already.
std::int64_t GltfSceneBuilder::place_positions(std::uint32_t accessor, const glm::dmat4& world_from_node,
                                               Placed& placed) {
  const auto known = placed.find(accessor);
  if (known != placed.end()) {
    return known->second;
  }
  const auto first = static_cast<std::int64_t>(assembler_.vertices());
  const std::vector<glm::dvec3> positions = buffers_.vectors(accessor);
  spend(positions.size() * sizeof(glm::vec3));
  const bool moved = world_from_node != glm::dmat4(1.0);  // unmoved, even the sign of zero stays
  for (const glm::dvec3& position : positions) {
    const glm::dvec3 world = moved ? glm::dvec3(world_from_node * glm::dvec4(position, 1.0)) : position;
    assembler_.add_position({round_to_float(world.x), round_to_float(world.y), round_to_float(world.z)}, {});
  }
  placed.emplace(accessor, first);
  return first;
}

void GltfSceneBuilder::add_faces(const GltfPrimitive& primitive, const std::vector<std::uint32_t>& indices,
                                 std::int64_t first, bool mirrored) {
  const std::size_t triangles = triangle_count(primitive.mode, indices.size());
  if (primitive.mode == triangle_list && indices.size() % 3 != 0) {
    input_.warnings.add("primitives with corners left over", {},
                        [] { return std::string("a primitive has corners left over after its triangles"); });
  }
  spend(triangles * sizeof(Triangle));
  std::uint32_t material = no_material;
  if (primitive.material && triangles > 0) {
    std::uint32_t& known = material_of_scene_[*primitive.material];
    if (known == no_material) {
      known = static_cast<std::uint32_t>(materials_.size());
      materials_.push_back(model_.materials[*primitive.material]);
    }
    material = known;
  }
  const auto count = static_cast<std::int64_t>(model_.accessors[*primitive.positions].count);
  for (std::size_t i = 0; i < triangles; ++i) {
    std::array<std::int64_t, 3> corners{};
    const std::array<std::size_t, 3> places = corners_of(primitive.mode, i);
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = indices[places[k]];
    }
    if (*std::max_element(corners.begin(), corners.end()) >= count) {
      assembler_.drop_for_index("vertex index " +
                                    std::to_string(*std::max_element(corners.begin(), corners.end())) +
                                    " out of range of its primitive",
                                {});
      continue;
    }
    if (mirrored) {
      std::swap(corners[1], corners[2]);
    }
    assembler_.add_face(std::array{corners[0] + first, corners[1] + first, corners[2] + first}, material, {});
  }
}

/// Refuses a scene that is out of proportion to its file: nodes and primitives can repeat the same
/// data, and a few of them could fill the memory.
void GltfSceneBuilder::spend(std::uint64_t bytes) {
  constexpr std::uint64_t always_allowed = std::uint64_t{128} << 20U;
  constexpr std::uint64_t greatest_ratio = 100;
  constexpr std::uint64_t step = std::uint64_t{1} << 20U;
  const bool tell = bytes_ / step != (bytes_ + bytes) / step;
  bytes_ += bytes;
  if (bytes_ > always_allowed && bytes_ > greatest_ratio * buffers_.total_bytes()) {
    input_.fail({}, "refused: repeated meshes take more than 128 MiB and more than " +
                        std::to_string(greatest_ratio) + " times the file");
  }
  if (tell && !report_progress(input_.progress, "building", 0.5)) {
    input_.fail({}, "interrupted");
  }
}

/// Takes the first perspective camera: at the node's origin, along its -z, with its y up.
void GltfSceneBuilder::add_camera(const GltfCamera& camera, const glm::dmat4& world_from_node) {
  if (!camera.perspective) {
    input_.warnings.add("", {}, [] { return std::string("an orthographic camera is passed over"); });
    return;
  }
  const glm::dvec3 eye(world_from_node[3]);
  const glm::dvec3 forward = -glm::dvec3(world_from_node[2]);
  const glm::dvec3 up(world_from_node[1]);
  const bool usable = is_finite(eye) && is_finite(forward) && is_finite(up) &&
                      glm::length(glm::cross(forward, up)) > 0 && camera.vertical_fov > 0 &&
                      camera.vertical_fov < std::numbers::pi;
  if (!usable) {
    input_.warnings.add("", {}, [] { return std::string("a camera that cannot be used is passed over"); });
  } else if (!camera_) {
    camera_ = Camera{eye, eye + glm::normalize(forward), up, glm::degrees(camera.vertical_fov)};
  }
}

/// Moves the camera's target along its view to the depth of the scene's middle, to turn about.
void GltfSceneBuilder::aim_camera(Scene& scene) const {
  scene.camera = camera_;
  if (!camera_ || scene.positions.empty()) {
    return;
  }
  glm::dvec3 low(scene.positions.front());
  glm::dvec3 high = low;
  for (const glm::vec3& position : scene.positions) {
    low = glm::min(low, glm::dvec3(position));
    high = glm::max(high, glm::dvec3(position));
  }
  const glm::dvec3 forward = camera_->target - camera_->eye;
  const double depth = glm::dot((low + high) / 2.0 - camera_->eye, forward);
  if (depth > 0) {
    scene.camera->target = camera_->eye + depth * forward;
  }
}

}  // namespace hsr
