#include "scene/built_in/mesh_builder.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace hsr {
namespace {

// The sRGB transfer function (IEC 61966-2-1), from an 8-bit value to linear light.
float linear_from_srgb(std::uint32_t byte) {
  const double value = static_cast<double>(byte & 0xFFU) / 255.0;
  return static_cast<float>(value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4));
}

}  // namespace

Material make_material(std::string_view name, std::uint32_t rgb, double opacity) {
  Material material;
  material.name = name;
  material.color = {linear_from_srgb(rgb >> 16U), linear_from_srgb(rgb >> 8U), linear_from_srgb(rgb)};
  material.opacity = static_cast<float>(opacity);
  return material;
}

std::uint32_t MeshBuilder::vertex(const glm::dvec3& position) {
  scene_.positions.emplace_back(position);
  return static_cast<std::uint32_t>(scene_.positions.size() - 1);
}

std::uint32_t MeshBuilder::material(std::string_view name, std::uint32_t rgb, double opacity) {
  scene_.materials.push_back(make_material(name, rgb, opacity));
  current_material_ = static_cast<std::uint32_t>(scene_.materials.size() - 1);
  return current_material_;
}

void MeshBuilder::face(std::span<const std::uint32_t> corners) {
  for (std::size_t k = 2; k < corners.size(); ++k) {
    const std::uint32_t a = corners[0];
    const std::uint32_t b = corners[k - 1];
    const std::uint32_t c = corners[k];
    if (a == b || b == c || c == a) continue;
    scene_.triangles.push_back({{a, b, c}, face_count_, current_material_});
  }
  ++face_count_;
}

void MeshBuilder::polygon(std::initializer_list<glm::dvec3> corners) {
  std::vector<std::uint32_t> indices;
  indices.reserve(corners.size());
  for (const glm::dvec3& corner : corners) indices.push_back(vertex(corner));
  face(indices);
}

void MeshBuilder::parallelogram(const glm::dvec3& origin, const glm::dvec3& u, const glm::dvec3& v) {
  polygon({origin, origin + u, origin + u + v, origin + v});
}

void MeshBuilder::box(const glm::dvec3& least, const glm::dvec3& greatest) {
  // Corner number: 1 for greatest x, 2 for greatest y, 4 for greatest z.
  std::array<std::uint32_t, 8> corner{};
  for (unsigned k = 0; k < 8; ++k) {
    corner[k] = vertex({(k & 1U) != 0 ? greatest.x : least.x, (k & 2U) != 0 ? greatest.y : least.y,
                        (k & 4U) != 0 ? greatest.z : least.z});
  }
  face({corner[4], corner[6], corner[2], corner[0]});  // towards -x
  face({corner[1], corner[5], corner[4], corner[0]});  // towards -y
  face({corner[5], corner[7], corner[6], corner[4]});  // towards +z
  face({corner[1], corner[0], corner[2], corner[3]});  // towards -z
  face({corner[5], corner[1], corner[3], corner[7]});  // towards +x
  face({corner[6], corner[7], corner[3], corner[2]});  // towards +y
}

void MeshBuilder::mesh(const Scene& other, double scale, const glm::dvec3& offset) {
  const auto first_vertex = static_cast<std::uint32_t>(scene_.positions.size());
  const std::uint32_t first_face = face_count_;
  for (const glm::vec3& position : other.positions) vertex(glm::dvec3(position) * scale + offset);
  for (const Triangle& triangle : other.triangles) {
    Triangle& added = scene_.triangles.emplace_back(triangle);
    for (std::uint32_t& corner : added.corners) corner += first_vertex;
    added.face += first_face;
    added.material = current_material_;
    face_count_ = added.face + 1;
  }
}

Scene MeshBuilder::finish(const Camera& camera) {
  scene_.camera = camera;
  return std::move(scene_);
}

}  // namespace hsr
