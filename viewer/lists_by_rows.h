#pragma once

#include <algorithm>
#include <string_view>

#include "algorithm.h"

namespace hsr {

/// Renders the view with lists, a few rows at a time, as all lists of a picture may need more memory than
/// there is. Calls use(lists, first, rows) for each part from the top: the lists of the picture, in which
/// those of the rows first ... first + rows - 1 are filled.
template <class Use>
void render_lists_by_rows(Renderer& renderer, const View& view, RenderOptions options, std::string_view doing,
                          Use use) {
  constexpr int rows_at_once = 32;
  const Progress progress = options.progress;
  options.progress = {};
  Frame frame(view.width, view.height);
  for (int first = 0; first < view.height; first += rows_at_once) {
    const int rows = std::min(rows_at_once, view.height - first);
    frame.lists.emplace();
    options.window = PixelBox{0, view.width - 1, first, first + rows - 1};
    (void)renderer.render(view, options, frame);
    use(*frame.lists, first, rows);
    (void)report_progress(progress, doing, static_cast<double>(first + rows) / view.height);
  }
}

}  // namespace hsr
