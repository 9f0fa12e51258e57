#include "window/results/structure.h"

#include <algorithm>

#include "raycast/bvh.h"
#include "raycast/grid.h"

namespace hsr::window {

StructureKind structure_kind(const AlgorithmSpec& spec) {
  const auto chosen = spec.settings.find("structure");
  if (chosen == spec.settings.end()) return StructureKind::none;
  if (chosen->second == "bvh") return StructureKind::hierarchy;
  return chosen->second == "grid" ? StructureKind::grid : StructureKind::none;
}

std::optional<Box> Structure::box(std::uint32_t number) const {
  if (!nodes.empty()) return number < nodes.size() ? std::optional(nodes[number].box) : std::nullopt;
  const auto x = static_cast<std::uint32_t>(resolution[0]);
  const auto y = static_cast<std::uint32_t>(resolution[1]);
  if (x == 0 || y == 0 || number / x / y >= static_cast<std::uint32_t>(resolution[2])) return std::nullopt;
  const glm::dvec3 corner = least + cell_size * glm::dvec3(number % x, number / x % y, number / x / y);
  return Box{glm::vec3(corner), glm::vec3(corner + cell_size)};
}

Structure find_structure(const StructureKey& key, const Scene& scene) {
  Structure structure;
  if (key.kind == StructureKind::hierarchy) {
    const BoundingVolumeHierarchy hierarchy(scene);
    structure.nodes.resize(hierarchy.nodes().size());
    for (std::size_t k = 0; k < structure.nodes.size(); ++k) {  // children stand behind their parent
      const BoundingVolumeHierarchy::Node& node = hierarchy.nodes()[k];
      Structure::Node& drawn = structure.nodes[k];
      drawn.box = node.box;
      drawn.leaf = node.count > 0;
      structure.levels = std::max(structure.levels, drawn.level + 1);
      if (drawn.leaf) continue;
      for (const std::uint32_t child : {node.first, node.first + 1})
        structure.nodes[child].level = drawn.level + 1;
    }
  }
  if (key.kind == StructureKind::grid) {
    const UniformGrid grid(scene);
    structure.least = grid.least();
    structure.cell_size = grid.cell_size();
    structure.resolution = grid.resolution();
    for (std::uint32_t cell = 0; cell + 1 < grid.begin().size(); ++cell) {
      if (grid.begin()[cell] < grid.begin()[cell + 1]) structure.cells.push_back(cell);
    }
  }
  return structure;
}

}  // namespace hsr::window
