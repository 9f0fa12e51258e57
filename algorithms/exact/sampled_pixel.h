#pragma once

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "exact/row_coverage.h"
#include "exact/worker.h"

namespace hsr::exact {

/// The colour of one pixel after the other as the mean of its samples. One per thread; what it is made
/// from must outlive it.
class SampledPixel {
 public:
  /// `surface` has the premultiplied colours by id.
  SampledPixel(Worker& worker, const std::vector<glm::vec4>& surface) : worker_(worker), surface_(surface) {}

  /// The pixel (i, j), where the triangles `here`, by increasing id, cover samples.
  glm::vec4 color(std::vector<const RowCoverage*>& here, int i, int j);

 private:
  bool opaque(const RowCoverage& triangle) const { return surface_[triangle.id].a >= 1.0F; }
  /// Whether p lies before q in all of the pixel.
  bool surely_nearer(const RowCoverage& p, const RowCoverage& q, int i, int j) const;
  void leave_out_hidden(std::vector<const RowCoverage*>& here, int i, int j) const;
  glm::vec4 mean_of_nearest(const std::vector<const RowCoverage*>& here, int i, int j);
  glm::vec4 mean_of_lists(const std::vector<const RowCoverage*>& here, int i, int j);
  glm::vec4 composited(std::vector<std::uint32_t>& ids, int column, int row);

  Worker& worker_;
  const std::vector<glm::vec4>& surface_;
  std::array<std::vector<std::uint32_t>, samples_across> lists_;  // of a row of samples
};

}  // namespace hsr::exact
