#include "truth.h"

#include "exact/exact_colors.h"
#include "exact/sampled_colors.h"
#include "lists_by_rows.h"

namespace hsr {

Truth::Truth(const View& view, bool antialiased, int threads, const Progress& progress)
    : answer(view, threads, progress),
      nearest(answer.nearest(threads, progress)),
      colors(exact::exact_colors(view, answer, nearest, threads, progress)) {
  if (antialiased) mean_colors = exact::sampled_colors(view, threads, progress);
}

exact::ListErrors measure_lists(Renderer& renderer, const View& view, const RenderOptions& options,
                                const Truth& truth) {
  exact::ListErrors errors;
  render_lists_by_rows(renderer, view, options, "comparing the lists",
                       [&](const FragmentLists& lists, int first, int rows) {
                         errors += exact::measure_list_errors(lists, truth.answer, view.width,
                                                              {first, first + rows}, options.threads);
                       });
  return errors;
}

}  // namespace hsr
