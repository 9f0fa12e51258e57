#include <cmath>
#include <string>

#include "algorithm.h"
#include "exact/exact_answer.h"
#include "fuzz/support/byte_source.h"
#include "fuzz/support/compare_answers.h"
#include "fuzz/support/random_view.h"
#include "fuzz/targets.h"

namespace hsr::fuzz {

namespace {

std::string value_for(const Setting& setting, unsigned byte) {
  if (byte < setting.choices.size()) return std::string(setting.choices[byte]);
  if (!setting.range) return std::string(setting.choices[byte % setting.choices.size()]);
  const auto values = static_cast<unsigned>(setting.range->greatest - setting.range->least) + 1;
  return std::to_string(setting.range->least + static_cast<int>(byte % values));
}

Frame rendered(const Algorithm& algorithm, const Settings& settings, const RenderOptions& options,
               const View& view) {
  Frame frame(view.width, view.height);
  algorithm.prepare(*view.scene, settings, options)->render(view, options, frame);
  return frame;
}

/// What must hold of any frame, however wrong the algorithm may be.
void check_frame(const Frame& frame, const View& view, std::string_view spec) {
  const std::string in = std::string(spec) + ": ";
  require(frame.width == view.width && frame.height == view.height, in + "a frame keeps its size");
  for (std::size_t pixel = 0; pixel < frame.pixel_count(); ++pixel) {
    const bool is_background = frame.id[pixel] == background_id;
    require(is_background || frame.id[pixel] < view.scene->triangles.size(), in + "every id is in range");
    require(!std::isnan(frame.depth[pixel]), in + "every depth is a number");
    require(!is_background || std::isinf(frame.depth[pixel]), in + "the background is infinitely far");
    for (int channel = 0; channel < 4; ++channel) {
      const float value = frame.color[pixel][channel];
      require(value >= 0.0F && value <= 1.0F, in + "every channel of a colour is within [0, 1]");
    }
  }
}

/// The choices of the bytes for one algorithm: which skips to do without, and other settings.
struct Choices {
  explicit Choices(ByteSource& source) : skips_off(source.byte()), settings(source.take<std::uint32_t>()) {}

  RenderOptions options(const Algorithm& algorithm) const {
    RenderOptions options;
    for (std::size_t k = 0; k < algorithm.skips.size(); ++k) {
      if ((skips_off >> k & 1U) != 0) options.skips_off.emplace(algorithm.skips[k].name);
    }
    return options;
  }

  AlgorithmSpec spec(const Algorithm& algorithm) const {
    AlgorithmSpec spec{&algorithm, {}};
    for (std::size_t k = 0; k < algorithm.settings.size(); ++k) {
      const Setting& setting = algorithm.settings[k];
      spec.settings.emplace(setting.name, value_for(setting, settings >> (8 * (k % 4)) & 0xFFU));
    }
    return spec;
  }

  unsigned skips_off;
  std::uint32_t settings;
};

}  // namespace

// A view out of bytes through every algorithm: in its default settings, which for the exact ones must
// give the exact answer whatever skips are left out, and in settings of the bytes' choice.
void render(std::string_view bytes) {
  ByteSource source(bytes);
  const bool ask_rationals = source.byte() % 4 == 0;
  const Choices choices(source);
  const Viewpoint viewpoint = take_viewpoint(source);
  const Scene scene = take_scene(source);
  const std::optional<View> view = view_from(viewpoint, scene);
  if (!view) return;

  const exact::ExactAnswer exact(*view, 1);
  const exact::Nearest nearest = exact.nearest(1);
  if (ask_rationals) check_exact_answer(exact, nearest, *view);
  for (const Algorithm* algorithm : algorithm_catalog()) {
    const RenderOptions options = choices.options(*algorithm);
    const AlgorithmSpec defaults = parse_algorithm_spec(algorithm->name);
    const Frame frame = rendered(*algorithm, defaults.settings, options, *view);
    check_frame(frame, *view, algorithm->name);
    if (algorithm->traits.exact) check_exact_frame(frame, nearest, exact, *algorithm);

    const AlgorithmSpec chosen = choices.spec(*algorithm);
    check_frame(rendered(*algorithm, chosen.settings, options, *view), *view, chosen.text());
  }
}

}  // namespace hsr::fuzz
