#include <algorithm>
#include <array>
#include <cmath>

#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"
#include "scene/built_in/random.h"

namespace hsr::built_in {
namespace {

// Scenes that algorithms which bring faces into an order are measured with. All fill the box of
// 6 × 3.4 × 2 about the origin.
constexpr glm::dvec3 half_box{3.0, 1.7, 1.0};
constexpr Camera in_front{.eye = {0.0, 0.0, 4.0}, .target = {0.0, 0.0, 0.0}};

/// The box divided into at least `count` equal blocks that are nearly cubes.
class Blocks {
 public:
  explicit Blocks(int count) {
    const double side = std::cbrt(8.0 * half_box.x * half_box.y * half_box.z / count);
    for (glm::length_t axis = 0; axis < 3; ++axis) blocks_[axis] = std::ceil(2.0 * half_box[axis] / side);
    size_ = 2.0 * half_box / blocks_;
  }
  glm::dvec3 size() const { return size_; }
  glm::dvec3 centre(int block) const {
    const double x = std::fmod(block, blocks_.x);
    const double rest = std::floor(block / blocks_.x);
    const double y = std::fmod(rest, blocks_.y);
    return (glm::dvec3(x, y, std::floor(rest / blocks_.y)) + 0.5) * size_ - half_box;
  }

 private:
  glm::dvec3 blocks_{1.0};
  glm::dvec3 size_{1.0};
};

constexpr std::array<SceneParameter, 1> separate_parameters{{
    {"n", "number of triangles", 400, 1, 10000000, true},
}};

// Each triangle has a block of its own, with corners anywhere in it.
Scene make_separate(std::span<const double> values) {
  const int n = static_cast<int>(values[0]);
  const Blocks blocks(n);
  MeshBuilder builder("separate");
  Random random(4);
  for (int k = 0; k < n; ++k) {
    const glm::dvec3 centre = blocks.centre(k);
    const auto corner = [&] { return centre + random.in_box(-0.5 * blocks.size(), 0.5 * blocks.size()); };
    const glm::dvec3 a = corner();
    const glm::dvec3 b = corner();
    builder.polygon({a, b, corner()});
  }
  return builder.finish(in_front);
}

constexpr std::array<SceneParameter, 1> three_cycles_parameters{{
    {"n", "number of cycles, of three triangles each", 100, 1, 3000000, true},
}};

// In each block three thin triangles along the sides of an equilateral one, each of which rises from below
// the one before it to above the next.
Scene make_three_cycles(std::span<const double> values) {
  const int n = static_cast<int>(values[0]);
  const Blocks blocks(n);
  const double scale = 0.45 * std::min({blocks.size().x, blocks.size().y, blocks.size().z});
  constexpr std::array<double, 3> cosine{1.0, -0.5, -0.5};
  constexpr std::array<double, 3> sine{0.0, 0.8660254037844386, -0.8660254037844386};
  MeshBuilder builder("three-cycles");
  for (int k = 0; k < n; ++k) {
    for (std::size_t turn = 0; turn < 3; ++turn) {
      const auto turned = [&](const glm::dvec3& p) {
        return blocks.centre(k) + scale * glm::dvec3(cosine[turn] * p.x - sine[turn] * p.y,
                                                     sine[turn] * p.x + cosine[turn] * p.y, p.z);
      };
      builder.polygon({turned({-0.8, -0.5, -0.4}), turned({-0.8, -0.2, -0.4}), turned({0.9, -0.35, 0.4})});
    }
  }
  return builder.finish(in_front);
}

constexpr std::array<SceneParameter, 2> stretched_parameters{{
    {"aspect", "how many times longer than wide, about", 64, 1, 100000, false},
    {"n", "number of triangles", 150, 1, 10000000, true},
}};

// Triangles of one area, 0.01, whatever their aspect, each with a centre and a direction of its own.
Scene make_stretched(std::span<const double> values) {
  const double half_length = 0.1 * std::sqrt(values[0]);
  const double half_width = 0.1 / std::sqrt(values[0]);
  MeshBuilder builder("stretched");
  Random random(5);
  for (int k = 0; k < static_cast<int>(values[1]); ++k) {
    const glm::dvec3 centre = random.in_box(-half_box, half_box);
    const glm::dvec3 along = random.on_sphere() * half_length;
    const glm::dvec3 side = random.on_sphere() * half_width;
    builder.polygon({centre - along - side, centre - along + side, centre + along});
  }
  return builder.finish(in_front);
}

}  // namespace

constinit const SceneEntry separate{
    .name = "separate",
    .title = "Triangles apart",
    .shows = "Triangles that do not touch, each in a block of its own: nearly any sort by depth is right.",
    .parameters = separate_parameters,
    .make = make_separate};

constinit const SceneEntry three_cycles{
    .name = "three-cycles",
    .title = "Many small cycles",
    .shows = "Threes of triangles that overlap in a cycle: each three needs one cut, whatever their number.",
    .parameters = three_cycles_parameters,
    .make = make_three_cycles};

constinit const SceneEntry stretched{
    .name = "stretched",
    .title = "Triangles stretched, of one area",
    .shows = "Triangles that cover the same area however long they are: boxes round them tell less and less.",
    .parameters = stretched_parameters,
    .make = make_stretched};

}  // namespace hsr::built_in
