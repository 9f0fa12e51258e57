#include "window/results/extras.h"

#include <algorithm>
#include <limits>

#include "picture.h"
#include "scene/errors.h"
#include "window/variants.h"

namespace hsr::window {
namespace {

bool writes(const Event& event) {
  return event.kind == EventKind::painted || event.kind == EventKind::fragment_stored ||
         event.kind == EventKind::nearest_replaced || (event.kind == EventKind::depth_tested && event.passed);
}

/// One picture: how long it took, or `limit_ms` if it would have taken longer.
double render_once(const PictureKey& key, const Surroundings& given, PreparedRenderers& prepared,
                   const Progress& progress, double limit_ms) {
  const Stopwatch since;
  const Progress within = [&](std::string_view, double done) {
    return since.milliseconds() < limit_ms && report_progress(progress, "measuring what skips save", done);
  };
  const RenderOptions options = {given.threads, key.skips_off, progress};
  const View view = view_of(given, key.view);
  Renderer& renderer = *prepared.get(*given.model, key, options).renderer;
  Frame frame(view.width, view.height);
  const Stopwatch stopwatch;
  (void)renderer.render(view, {given.threads, key.skips_off, within}, frame);
  if (!report_progress(progress, "measuring what skips save", 1.0)) throw InputError("stopped");
  return std::min(stopwatch.milliseconds(), limit_ms);
}

}  // namespace

std::vector<std::uint32_t> count_overdraw(const PictureKey& key, const Surroundings& given,
                                          const Progress& progress) {
  const View view = view_of(given, key.view);
  const RenderOptions options = {1, key.skips_off, progress};
  const AlgorithmSpec spec = telling_version(spec_of(key));
  const auto renderer = given.told ? told_renderer(given.told)
                                   : spec.algorithm->prepare(*given.model->scene, spec.settings, options);
  Frame frame(view.width, view.height);
  std::vector<std::uint32_t> counts(frame.pixel_count());
  const auto count = [&](const Event& event) {
    if (writes(event) && event.i >= 0) ++counts[frame.index(event.i, event.j)];
  };
  (void)renderer->trace(view, options, count, frame);
  if (!report_progress(progress, "counting", 1.0)) throw InputError("stopped");
  return counts;
}

SkipTimes measure_skips(const SkipsKey& wanted, const Surroundings& given, PreparedRenderers& prepared,
                        const Progress& progress) {
  const PictureKey& key = wanted.picture;
  SkipTimes times;
  constexpr double longest_ms = 1000.0;
  const double with_limit_ms = wanted.patient ? std::numeric_limits<double>::infinity() : longest_ms;
  times.with_ms = render_once(key, given, prepared, progress, with_limit_ms);
  times.too_long = times.with_ms >= with_limit_ms;
  if (times.too_long) return times;
  constexpr double patience_ms = 200.0;
  const int rounds = std::clamp(static_cast<int>(patience_ms / std::max(times.with_ms, 1e-3)), 1, 5);
  const double without_limit_ms = 3.0 * std::max(times.with_ms, longest_ms);
  for (const Skip& skip : spec_of(key).algorithm->skips) {
    if (key.skips_off.contains(skip.name)) continue;
    PictureKey without = key;
    without.skips_off.insert(std::string(skip.name));
    double with_ms = std::numeric_limits<double>::infinity();
    double without_ms = with_ms;
    for (int round = 0; round < rounds; ++round) {
      without_ms = std::min(without_ms, render_once(without, given, prepared, progress, without_limit_ms));
      with_ms = std::min(with_ms, render_once(key, given, prepared, progress, with_limit_ms));
    }
    times.saved[std::string(skip.name)] = {without_ms - with_ms, without_ms >= without_limit_ms};
  }
  return times;
}

}  // namespace hsr::window
