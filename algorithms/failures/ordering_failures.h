#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "algorithm.h"
#include "exact/exact_answer.h"
#include "failures/cause.h"
#include "failures/evidence.h"

namespace hsr {

/// Pixels where one triangle is shown in place of another, for one cause.
struct FailingPair {
  std::uint32_t shown = background_id;    ///< background_id: a hole
  std::uint32_t nearest = background_id;  ///< the lowest admissible id; background_id: a leak
  Cause cause = Cause::unknown;
  std::uint64_t pixels = 0;
  int i = 0;  ///< the first such pixel
  int j = 0;

  // The proof, where the cause has one.
  std::array<glm::dvec2, 2> crossing{};  ///< interpenetration: ends of the segment, raster coordinates
  std::vector<std::uint32_t>
      cycle;  ///< cyclic overlap: each has to be painted before the next, the last before the first
  std::array<double, 2> keys{};  ///< sort key: of shown and nearest, as the algorithm sorted
};

/// What is wrong with a frame, and why.
struct OrderingFailures {
  std::array<std::uint64_t, cause_count> pixels{};  ///< by cause
  std::vector<FailingPair> pairs;                   ///< those with the most pixels first
  std::vector<std::uint32_t> pair_at;               ///< per pixel: index into pairs, or background_id

  std::uint64_t of(Cause cause) const { return pixels[static_cast<std::size_t>(cause)]; }
};

/// Finds the cause of every pixel of `frame` that shows an inadmissible triangle, nothing where
/// something is, or something where nothing is, and of every wrong blend. `spec` made the frame of this
/// view; `nearest` and `colors` come from `exact`. Each cause is proven: by the algorithm's own steps,
/// told once more (by the renderer of `maker`, if given: then `spec` is in no catalogue), by the segment
/// where two triangles cross, or by a cycle in the exact depth lists.
OrderingFailures find_failures(const View& view, const AlgorithmSpec& spec, const RenderOptions& options,
                               const Frame& frame, const exact::ExactAnswer& exact,
                               const exact::Nearest& nearest, const std::vector<glm::vec4>& colors,
                               const RendererMaker& maker = {});

/// One sentence that names the pair, the cause and its proof.
std::string sentence(const FailingPair& pair);

}  // namespace hsr
