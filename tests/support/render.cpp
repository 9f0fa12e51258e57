#include "support/render.h"

#include <utility>

#include "exact/exact_answer.h"
#include "exact/exact_colors.h"

namespace hsr::test {

namespace {

Frame rendered(Frame frame, const View& view, std::string_view spec_text, const RenderOptions& options) {
  const AlgorithmSpec spec = parse_algorithm_spec(spec_text);
  spec.algorithm->prepare(*view.scene, spec.settings, options)->render(view, options, frame);
  return frame;
}

}  // namespace

Frame render(const View& view, std::string_view spec_text, const RenderOptions& options) {
  return rendered(Frame(view.width, view.height), view, spec_text, options);
}

Frame render_with_lists(const View& view, std::string_view spec_text, const RenderOptions& options) {
  Frame frame(view.width, view.height);
  frame.lists.emplace();
  return rendered(std::move(frame), view, spec_text, options);
}

namespace {

// All parts but one, as the value of a setting.
std::string all_but(std::span<const std::string_view> parts, std::string_view left_out) {
  std::string value;
  for (const std::string_view part : parts) {
    if (part != left_out) value.append(value.empty() ? "" : "+").append(part);
  }
  return value;
}

}  // namespace

std::vector<std::string> every_setting(const Algorithm& algorithm) {
  std::vector<std::string> specs = {std::string(algorithm.name)};
  const auto add = [&](std::string_view setting, std::string_view value) {
    specs.push_back(std::string(algorithm.name) + "[" + std::string(setting) + "=" + std::string(value) +
                    "]");
  };
  for (const Setting& setting : algorithm.settings) {
    for (const std::string_view choice : setting.choices.subspan(1)) add(setting.name, choice);
    for (const std::string_view left_out : setting.parts) add(setting.name, all_but(setting.parts, left_out));
    if (setting.range) add(setting.name, std::to_string(setting.range->least));
  }
  return specs;
}

exact::Errors errors_of(const View& view, std::string_view spec_text) {
  constexpr int threads = 2;
  const exact::ExactAnswer exact(view, threads);
  const exact::Nearest nearest = exact.nearest(threads);
  return measure_errors(render(view, spec_text), exact, nearest, exact_colors(view, exact, nearest, threads));
}

}  // namespace hsr::test
