#include "support/render.h"

#include "exact/exact_answer.h"
#include "exact/exact_colors.h"

namespace hsr::test {

Frame render(const View& view, std::string_view spec_text, const RenderOptions& options) {
  const AlgorithmSpec spec = parse_algorithm_spec(spec_text);
  Frame frame(view.width, view.height);
  spec.algorithm->prepare(*view.scene, spec.settings, options)->render(view, options, frame);
  return frame;
}

exact::Errors errors_of(const View& view, std::string_view spec_text) {
  constexpr int threads = 2;
  const exact::ExactAnswer exact(view, threads);
  const exact::Nearest nearest = exact.nearest(threads);
  return measure_errors(render(view, spec_text), exact, nearest, exact_colors(view, exact, nearest, threads));
}

}  // namespace hsr::test
