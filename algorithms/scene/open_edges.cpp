#include "scene/open_edges.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace hsr {

EdgeCounts count_edges(const Scene& scene) {
  // Both ends in one number, the smaller first, so that equal edges stand together once sorted.
  std::vector<std::uint64_t> edges;
  edges.reserve(3 * scene.triangles.size());
  for (const Triangle& triangle : scene.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [least, greatest] = std::minmax(triangle.corners[k], triangle.corners[(k + 1) % 3]);
      edges.push_back(std::uint64_t{least} << 32U | greatest);
    }
  }
  std::ranges::sort(edges);
  EdgeCounts counts;
  for (std::size_t first = 0; first < edges.size();) {
    std::size_t last = first + 1;
    while (last < edges.size() && edges[last] == edges[first]) ++last;
    ++counts.edges;
    if (last == first + 1) ++counts.open;
    first = last;
  }
  return counts;
}

}  // namespace hsr
