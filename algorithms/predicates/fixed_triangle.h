#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "predicates/homogeneous.h"
#include "predicates/wide_whole.h"
#include "scene/scene.h"

namespace hsr {

/// The numbers of a projection as whole numbers times one power of two.
struct FixedProjection {
  std::array<std::array<WideWhole<3>, 4>, 3> rows{};
  int width = 0;
  int height = 0;
};

/// Nothing where the numbers' exponents differ by too much (some 70 binary digits) for 126 bits.
std::optional<FixedProjection> fixed_projection(const Projection& projection);

/// Points in clip space as whole numbers times one power of two, the same for all of them. False where the
/// positions' exponents differ by too much. As many of `clip` as of `world`.
bool fixed_clip_from_world(const FixedProjection& projection, std::span<const glm::vec3> world,
                           std::span<Homogeneous<WideWhole<3>>> clip);

/// The edges of a triangle in exact numbers of fixed width: a hundred times faster than numbers of any size,
/// and wide enough for nearly all scenes.
class FixedTriangle {
 public:
  /// Nothing where the positions' exponents differ by too much.
  static std::optional<FixedTriangle> make(const FixedProjection& projection, const Scene& scene,
                                           std::uint32_t id);

  /// The sign of e_k · p at a sample, -1, 0 or 1: not turned by the sign of det. |a| <= W, |b| <= H, whole.
  int edge_sign(std::size_t k, double a, double b) const;

 private:
  // W and H times the picture's are below 2^32: products with them need one part more.
  std::array<std::array<WideWhole<7>, 3>, 3> edge_{};
  std::int64_t width_ = 0;
  std::int64_t height_ = 0;
};

}  // namespace hsr
