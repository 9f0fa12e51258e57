#include "exact/sampled_colors.h"

#include <doctest/doctest.h>

#include <optional>

#include "exact/exact_answer.h"
#include "exact/exact_colors.h"
#include "scene/catalog.h"
#include "support/small_scenes.h"

namespace {

// The mean of the exact colours of a picture 32 times as large.
void check_against_large_picture(const hsr::View& view) {
  hsr::View large = view;
  large.width *= 32;
  large.height *= 32;
  const hsr::exact::ExactAnswer exact(large, 2);
  const std::vector<glm::vec4> samples = exact_colors(large, exact, exact.nearest(2), 2);
  const std::vector<glm::vec4> colors = hsr::exact::sampled_colors(view, 2);
  REQUIRE(colors.size() == static_cast<std::size_t>(view.width * view.height));
  double greatest = 0.0;
  for (int j = 0; j < view.height; ++j) {
    for (int i = 0; i < view.width; ++i) {
      glm::dvec4 sum(0.0);
      for (int row = 0; row < 32; ++row) {
        for (int column = 0; column < 32; ++column) {
          sum +=
              glm::dvec4(samples[static_cast<std::size_t>((j * 32 + row) * large.width + i * 32 + column)]);
        }
      }
      const glm::dvec4 difference =
          sum / 1024.0 - glm::dvec4(colors[static_cast<std::size_t>(j * view.width + i)]);
      for (int channel = 0; channel < 4; ++channel) {
        greatest = std::max(greatest, std::abs(difference[channel]));
      }
    }
  }
  CHECK(greatest < 1e-6);
}

}  // namespace

TEST_CASE("exact: sampled colours are the means of a picture 32 times as large") {
  for (const char* name : {"three-bars", "crossing", "coplanar", "glass", "cube", "soup:60", "hair-apart"}) {
    CAPTURE(name);
    const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(name);
    REQUIRE(scene);
    check_against_large_picture(hsr::make_view(*scene, *scene->camera, 16, 10));
  }
}

TEST_CASE("exact: sampled colours of troublesome scenes, half of them of glass") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    hsr::Scene scene = hsr::test::troublesome_scene(seed, 20);
    scene.materials = {{"glass", {1.0F, 0.5F, 0.0F}, 0.5F}};
    for (std::size_t id = 0; id < scene.triangles.size(); id += 2) scene.triangles[id].material = 0;
    check_against_large_picture(hsr::test::front_view(scene, 8, 6, 4.0, 0.5, 7.0));
  }
}
