#include "scene/open_edges.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace hsr {

namespace {

struct Edge {
  std::uint32_t greater;   // the end with the greater index
  std::uint32_t triangle;  // one that has it
};

// The edges of all triangles, in a list for each vertex: those on which it is the lesser end.
class EdgesByVertex {
 public:
  explicit EdgesByVertex(const Scene& scene) : begin_(scene.positions.size() + 1, 0) {
    visit_edges(scene, [&](std::uint32_t least, std::uint32_t, std::uint32_t) { ++begin_[least + 1]; });
    for (std::size_t vertex = 1; vertex < begin_.size(); ++vertex) begin_[vertex] += begin_[vertex - 1];
    edges_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    visit_edges(scene, [&](std::uint32_t least, std::uint32_t greatest, std::uint32_t triangle) {
      edges_[next[least]++] = {greatest, triangle};
    });
  }

  // Calls visit(lesser end, greater end, triangle) for every edge that one triangle alone has.
  template <class Visit>
  void visit_open(Visit visit) {
    for (std::uint32_t least = 0; least + 1 < begin_.size(); ++least) {
      const auto begin = edges_.begin() + static_cast<std::ptrdiff_t>(begin_[least]);
      const auto end = edges_.begin() + static_cast<std::ptrdiff_t>(begin_[least + 1]);
      std::sort(begin, end, [](const Edge& p, const Edge& q) { return p.greater < q.greater; });
      for (auto edge = begin; edge != end;) {
        const auto next = std::find_if(edge, end, [&](const Edge& q) { return q.greater != edge->greater; });
        if (next - edge == 1) visit(least, edge->greater, edge->triangle);
        edge = next;
      }
    }
  }

 private:
  // A corner that a triangle repeats makes no edge.
  template <class Visit>
  static void visit_edges(const Scene& scene, Visit visit) {
    for (std::uint32_t id = 0; id < scene.triangles.size(); ++id) {
      const std::array<std::uint32_t, 3>& corners = scene.triangles[id].corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [least, greatest] = std::minmax(corners[k], corners[(k + 1) % 3]);
        if (least != greatest) visit(least, greatest, id);
      }
    }
  }

  std::vector<std::size_t> begin_;
  std::vector<Edge> edges_;
};

struct OpenEdge {
  std::uint32_t least;
  std::uint32_t greatest;
  std::uint32_t triangle;
};

// For each triangle, whether another one shares an edge with it.
std::vector<bool> joined_triangles(const std::vector<OpenEdge>& open, std::size_t triangle_count) {
  std::vector<std::uint8_t> open_sides(triangle_count, 0);
  for (const OpenEdge& edge : open) ++open_sides[edge.triangle];
  std::vector<bool> joined(triangle_count);
  std::transform(open_sides.begin(), open_sides.end(), joined.begin(),
                 [](std::uint8_t sides) { return sides < 3; });
  return joined;
}

// Each hole is found once, from its edge between the lowest and the middle of its vertices. Triangles
// that nothing is joined to, such as one by itself, enclose no hole. `open` is in order of the ends.
std::size_t count_triangular_holes(const std::vector<OpenEdge>& open, const std::vector<bool>& joined) {
  // Where more open edges meet, as round the hub of a fan, there is no slip to be told of, and looking
  // through all pairs of them could take for ever.
  constexpr std::ptrdiff_t most_edges_at_a_vertex = 64;
  using Ends = std::pair<std::uint32_t, std::uint32_t>;
  const auto ends = [](const OpenEdge& edge) { return Ends(edge.least, edge.greatest); };
  std::size_t holes = 0;
  for (const OpenEdge& low : open) {
    const auto from_middle = std::ranges::equal_range(open, low.greatest, {}, &OpenEdge::least);
    if (std::ranges::ssize(from_middle) > most_edges_at_a_vertex) continue;
    for (const OpenEdge& across : from_middle) {
      const Ends wanted(low.least, across.greatest);
      const auto closing = std::ranges::lower_bound(open, wanted, {}, ends);
      if (closing == open.end() || ends(*closing) != wanted) continue;
      if (joined[low.triangle] && joined[across.triangle] && joined[closing->triangle]) ++holes;
    }
  }
  return holes;
}

}  // namespace

OpenEdges open_edges(const Scene& scene) {
  std::vector<OpenEdge> open;
  EdgesByVertex(scene).visit_open([&](std::uint32_t least, std::uint32_t greatest, std::uint32_t triangle) {
    open.push_back({least, greatest, triangle});
  });
  return {open.size(), count_triangular_holes(open, joined_triangles(open, scene.triangles.size()))};
}

}  // namespace hsr
