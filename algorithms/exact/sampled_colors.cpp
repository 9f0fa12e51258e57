#include "exact/sampled_colors.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "exact/integer_triangle.h"
#include "exact/prepared_triangle.h"
#include "exact/row_coverage.h"
#include "exact/sampled_pixel.h"
#include "exact/worker.h"
#include "parallel.h"
#include "view/shading.h"

namespace hsr::exact {

namespace {

struct RowRange {
  int first;
  int last;
};

// The view of which every sample is a pixel. Its size may be beyond what make_view allows.
View view_of_samples(const View& view) {
  View samples = view;
  samples.width *= samples_across;
  samples.height *= samples_across;
  return samples;
}

// Everything that all rows share.
class Sampling {
 public:
  Sampling(const View& view, int threads, const Progress& progress)
      : view_(view_of_samples(view)),
        triangles_(view.scene->triangles.size()),
        rows_(triangles_.size()),
        surface_(surface_colors(*view.scene, threads)),
        width_(view.width) {
    std::atomic<std::size_t> done = 0;
    parallel_for_blocks(triangles_.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t id = first; id < last; ++id) {
        triangles_[id] = PreparedTriangle(view_, static_cast<std::uint32_t>(id));
        rows_[id] = {triangles_[id].first_row, triangles_[id].last_row};
      }
      done += last - first;
      report_progress(progress, "preparing the samples",
                      static_cast<double>(done) / static_cast<double>(triangles_.size()));
    });
  }

  // The colours of row j of pixels, from `color` on.
  void row(int j, glm::vec4* color) const {
    Worker worker(view_, triangles_);
    const int first_row = j * samples_across;
    std::vector<RowCoverage> coverage;
    for (std::uint32_t id = 0; id < rows_.size(); ++id) {
      if (rows_[id].last < first_row || rows_[id].first >= first_row + samples_across) continue;
      RowCoverage covered(worker, id, j);
      if (covered.first_pixel <= covered.last_pixel) coverage.push_back(covered);
    }
    SampledPixel pixel(worker, surface_);
    std::array<std::vector<const RowCoverage*>, pixels_at_once> here;
    for (int first = 0; first < width_; first += pixels_at_once) {
      const int last = std::min(first + pixels_at_once, width_) - 1;
      spread(coverage, first, last, here);
      for (int i = first; i <= last; ++i) {
        color[i] = pixel.color(here[static_cast<std::size_t>(i - first)], i, j);
      }
    }
  }

 private:
  // So that triangles are not noted for each pixel of a whole row at a time.
  static constexpr int pixels_at_once = 32;

  // Notes the triangles that may have samples in each of the pixels first ... last, by increasing id.
  static void spread(const std::vector<RowCoverage>& coverage, int first, int last,
                     std::array<std::vector<const RowCoverage*>, pixels_at_once>& here) {
    for (std::vector<const RowCoverage*>& list : here) list.clear();
    for (const RowCoverage& triangle : coverage) {
      const int last_here = std::min(triangle.last_pixel, last);
      for (int i = std::max(triangle.first_pixel, first); i <= last_here; ++i) {
        here[static_cast<std::size_t>(i - first)].push_back(&triangle);
      }
    }
  }

  IntegerView view_;
  std::vector<PreparedTriangle> triangles_;  // by id
  std::vector<RowRange> rows_;               // of the same, close together
  std::vector<glm::vec4> surface_;
  int width_;
};

}  // namespace

std::vector<glm::vec4> sampled_colors(const View& view, int threads, const Progress& progress) {
  const Sampling sampling(view, threads, progress);
  const auto columns = static_cast<std::size_t>(view.width);
  std::vector<glm::vec4> colors(columns * static_cast<std::size_t>(view.height));
  std::atomic<int> rows_done = 0;
  parallel_for(view.height, threads, [&](int j) {
    sampling.row(j, &colors[static_cast<std::size_t>(j) * columns]);
    report_progress(progress, "sampling the exact answer", static_cast<double>(++rows_done) / view.height);
  });
  return colors;
}

}  // namespace hsr::exact
