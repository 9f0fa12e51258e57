#include "trace_animation.h"

#include <algorithm>
#include <vector>

#include "frame/write_gif.h"
#include "scene/atomic_file.h"
#include "trace/picture_state.h"
#include "view/shading.h"

namespace hsr {
namespace {

constexpr std::uint64_t most_pictures = 200;
constexpr int hundredths_in_all = 1000;
constexpr int least_hundredths = 4;  // viewers slow down what is shorter
constexpr int most_hundredths = 50;
constexpr int hundredths_at_end = 300;
constexpr int wanted_size = 480;  // small windows are enlarged up to this

/// Every colour that can occur; empty where surfaces are blended, as these are too many.
std::vector<glm::vec3> possible_colors(const std::vector<glm::vec4>& surfaces, const glm::vec3& backdrop) {
  std::vector<glm::vec3> colors = {backdrop, glm::vec3(edge_ink)};
  for (const glm::vec4& surface : surfaces) {
    if (surface.a < 1.0F) return {};
    colors.emplace_back(surface);
  }
  return colors;
}

void extend(PixelBox& box, int i, int j) {
  if (box.empty()) {
    box = {i, i, j, j};
  } else {
    box = {std::min(box.first_i, i), std::max(box.last_i, i), std::min(box.first_j, j),
           std::max(box.last_j, j)};
  }
}

/// The number of the step after which picture `k` of `pictures` is shown; 0 is before the first.
std::uint64_t step_of_picture(const AnimatedSteps& steps, std::uint64_t k, std::uint64_t pictures) {
  const std::uint64_t count = steps.last + 1 - steps.first;
  // count · k may not fit; both parts of it do.
  return steps.first - 1 + count / pictures * k + count % pictures * k / pictures;
}

}  // namespace

void write_animation(const View& view, const TracedRun& run, const AnimatedSteps& steps,
                     const glm::vec3& backdrop, int threads, const std::filesystem::path& file) {
  const std::vector<glm::vec4> surfaces = surface_colors(*view.scene, threads);
  const GifPalette palette(possible_colors(surfaces, backdrop));
  const PixelBox window = steps.filter.window.value_or(PixelBox{0, view.width - 1, 0, view.height - 1});
  const int size = std::max(window.last_i - window.first_i, window.last_j - window.first_j) + 1;
  const int scale = std::max(1, steps.filter.window ? wanted_size / size : 1);
  const std::uint64_t count = steps.last >= steps.first ? steps.last + 1 - steps.first : 0;
  const std::uint64_t pictures = std::min(count, most_pictures);
  const int hundredths =
      std::clamp(hundredths_in_all / static_cast<int>(pictures + 1), least_hundredths, most_hundredths);
  write_file_atomically(file, [&](const std::filesystem::path& temporary) {
    GifWriter writer(temporary, window, scale, palette, backdrop);
    PictureState state(view.width, view.height, surfaces);
    PixelBox changed;
    std::uint64_t shown = 0;  // pictures after the first, which shows what was before the first step
    std::uint64_t step = 0;
    if (steps.first == 1 || count == 0) writer.add(state.frame(), changed, hundredths);
    run([&](const Event& event) {
      if (step >= steps.last) return;
      (void)state.apply(event);
      if (event.i >= 0) extend(changed, event.i, event.j);
      if (!steps.filter.wants(event)) return;
      ++step;
      if (step + 1 == steps.first) {
        writer.add(state.frame(), changed, hundredths);
        changed = {};
      }
      if (step < steps.first || step < step_of_picture(steps, shown + 1, pictures)) return;
      ++shown;
      writer.add(state.frame(), changed, shown == pictures ? hundredths_at_end : hundredths);
      changed = {};
    });
    writer.finish();
  });
}

}  // namespace hsr
