#include <algorithm>
#include <array>

#include "stress/families/rows.h"
#include "stress/family.h"

namespace hsr::stress {
namespace {

constexpr int threads = 1;

View view_of(const Problem& problem) {
  return make_view(problem.scene, *problem.scene.camera, problem.width, problem.height, problem.near_depth,
                   problem.far_depth);
}

}  // namespace

SeenProblem::SeenProblem(Problem posed)
    : problem(std::move(posed)),
      view(view_of(problem)),
      answer(view, threads),
      nearest(answer.nearest(threads)) {}

std::span<const Family> families() {
  static const std::array table = {
      rows::planes_apart, rows::depth_ratio, rows::coplanar,    rows::grazing,   rows::layers,
      rows::near_centres, rows::on_centres,  rows::aimed,       rows::needles,   rows::kettner,
      rows::moved,        rows::scaled_up,   rows::scaled_down, rows::eye_plane, rows::near_plane,
      rows::bars,         rows::crossing,    rows::inside,      rows::mixed,
  };
  return table;
}

std::vector<int> difficulties(const Family& family, bool quick) {
  constexpr int dense = 32;
  constexpr int sparse_step = 8;
  constexpr int quick_steps = 5;
  std::vector<int> chosen = {family.differs_to, std::min(family.differs_to + 1, family.greatest)};
  const int range = family.greatest - family.least;
  if (quick) {
    for (int step = 0; step <= quick_steps; ++step) {
      chosen.push_back(family.least + range * step / quick_steps);
    }
  } else {
    for (int k = family.least; k <= family.greatest; k += k < family.least + dense ? 1 : sparse_step) {
      chosen.push_back(k);
    }
    chosen.push_back(family.greatest);
  }
  std::ranges::sort(chosen);
  const auto repeated = std::ranges::unique(chosen);
  chosen.erase(repeated.begin(), repeated.end());
  return chosen;
}

}  // namespace hsr::stress
