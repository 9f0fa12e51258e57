#include "exact/exact_colors.h"

#include <atomic>
#include <cstddef>

#include "parallel.h"
#include "view/shading.h"

namespace hsr::exact {

namespace {

// The fragments begin ... end - 1 of one pixel, front to back.
glm::vec4 composited(const DepthLists& lists, std::size_t begin, std::size_t end,
                     const std::vector<glm::vec4>& surface) {
  glm::vec4 color(0.0F);
  for (std::size_t place = begin; place < end; ++place) {
    if (lists.fragments[place].tied) continue;
    const glm::vec4& front_most = surface[lists.fragments[place].id];
    color = over(color, front_most);
    if (front_most.a >= 1.0F) break;
  }
  return color;
}

}  // namespace

std::vector<glm::vec4> exact_colors(const View& view, const ExactAnswer& exact, const Nearest& nearest,
                                    int threads, const Progress& progress) {
  const std::vector<glm::vec4> surface = surface_colors(*view.scene, threads);
  std::vector<glm::vec4> colors(nearest.id.size(), glm::vec4(0.0F));
  if (all_opaque(surface)) {
    for (std::size_t pixel = 0; pixel < colors.size(); ++pixel) {
      if (nearest.id[pixel] != background_id) colors[pixel] = surface[nearest.id[pixel]];
    }
    return colors;
  }
  std::atomic<int> rows_done = 0;
  parallel_for(view.height, threads, [&](int j) {
    const DepthLists lists = exact.depth_lists(j, j + 1);
    for (int i = 0; i < view.width; ++i) {
      const auto column = static_cast<std::size_t>(i);
      colors[static_cast<std::size_t>(j) * static_cast<std::size_t>(view.width) + column] =
          composited(lists, lists.begin[column], lists.begin[column + 1], surface);
    }
    report_progress(progress, "compositing the exact lists", static_cast<double>(++rows_done) / view.height);
  });
  return colors;
}

}  // namespace hsr::exact
