#include "window/results/truth.h"

#include "exact/exact_colors.h"
#include "exact/worker.h"
#include "picture.h"
#include "scene/errors.h"

namespace hsr::window {
namespace {

/// Half an answer must not be taken for a whole one.
void require_going(const Progress& progress, std::string_view stage) {
  if (!report_progress(progress, stage, 1.0)) throw InputError("stopped");
}

}  // namespace

Truth find_truth(const ViewKey& key, const Surroundings& given, const Progress& progress) {
  const Stopwatch stopwatch;
  Truth truth;
  truth.scene = given.model->scene;
  truth.view = view_of(given, key);
  truth.answer = std::make_shared<const exact::ExactAnswer>(truth.view, given.threads, progress);
  require_going(progress, "exact answer");
  truth.nearest = truth.answer->nearest(given.threads, progress);
  require_going(progress, "exact answer");
  truth.frame = Frame(key.size.width, key.size.height);
  truth.frame.color = exact::exact_colors(truth.view, *truth.answer, truth.nearest, given.threads, progress);
  require_going(progress, "exact colours");
  truth.frame.id = truth.nearest.id;
  for (std::size_t pixel = 0; pixel < truth.frame.pixel_count(); ++pixel) {
    truth.frame.depth[pixel] = static_cast<float>(truth.nearest.depth[pixel]);
  }
  truth.screen = screen_picture(truth.frame.color, truth.frame.width, truth.frame.height, given.backdrop);
  truth.milliseconds = stopwatch.milliseconds();
  return truth;
}

Judgement judge(const Rendered& rendered, const Truth& truth, const Progress& progress) {
  Judgement judgement;
  judgement.errors = exact::measure_errors(rendered.frame, *truth.answer, truth.nearest, truth.frame.color);
  require_going(progress, "comparing");
  exact::Worker worker = truth.answer->worker();
  const Frame& frame = rendered.frame;
  judgement.verdicts.assign(frame.pixel_count(), Verdict::right);
  for (int j = 0; j < frame.height; ++j) {
    for (int i = 0; i < frame.width; ++i) {
      const std::size_t pixel = frame.index(i, j);
      const std::uint32_t shown = frame.id[pixel];
      const std::uint32_t nearest = truth.nearest.id[pixel];
      if (shown == nearest) continue;
      Verdict verdict = Verdict::wrong;
      if (shown == background_id) {
        verdict = Verdict::hole;
      } else if (nearest == background_id) {
        verdict = Verdict::leak;
      } else if (worker.covers(shown, i, j) && worker.compare_depth(shown, nearest, i, j) == 0) {
        continue;  // the other of two that are equally near
      }
      judgement.verdicts[pixel] = verdict;
      judgement.failed.push_back(static_cast<std::uint32_t>(pixel));
    }
  }
  return judgement;
}

OrderingFailures find_causes(const PictureKey& key, const Surroundings& given, const Rendered& rendered,
                             const Truth& truth, const Progress& progress) {
  const AlgorithmSpec spec = spec_of(key);
  const RenderOptions options = {given.threads, key.skips_off, progress};
  RendererMaker maker;
  if (rendered.told) maker = [&rendered] { return told_renderer(rendered.told); };
  OrderingFailures failures = find_failures(truth.view, spec, options, rendered.frame, *truth.answer,
                                            truth.nearest, truth.frame.color, maker);
  require_going(progress, "finding causes");
  return failures;
}

}  // namespace hsr::window
