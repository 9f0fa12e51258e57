#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "raycast/box.h"
#include "window/results/rendered.h"

namespace hsr::window {

/// How an algorithm finds the triangles that a ray may meet.
enum class StructureKind : std::uint8_t { none, hierarchy, grid };

StructureKind structure_kind(const AlgorithmSpec& spec);

/// Which structure, over which scene.
struct StructureKey {
  std::uint64_t model = 0;
  StructureKind kind = StructureKind::none;
  bool operator==(const StructureKey&) const = default;
};

/// The boxes of a hierarchy or the cells of a grid, to be drawn, by the numbers that steps call them.
struct Structure {
  struct Node {
    Box box;
    int level = 0;  ///< of the root 0
    bool leaf = false;
  };
  std::vector<Node> nodes;           ///< of a hierarchy, by number
  std::vector<std::uint32_t> cells;  ///< of a grid: the numbers of those that hold triangles
  int levels = 0;                    ///< of a hierarchy: how many there are

  /// Of the node or cell with this number; nothing if there is none.
  std::optional<Box> box(std::uint32_t number) const;

  // Of a grid.
  glm::dvec3 least{0.0};
  glm::dvec3 cell_size{1.0};
  std::array<int, 3> resolution{};
};

/// Builds it once more, for the drawing alone: the same scene gives the same structure.
Structure find_structure(const StructureKey& key, const Scene& scene);

}  // namespace hsr::window
