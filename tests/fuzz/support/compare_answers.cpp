#include "fuzz/support/compare_answers.h"

#include <cmath>
#include <limits>
#include <string>

#include "exact/worker.h"
#include "fuzz/targets.h"
#include "support/rational_answer.h"

namespace hsr::fuzz {

namespace {

std::string at_pixel(std::size_t pixel, int width, std::string_view what) {
  const auto columns = static_cast<std::size_t>(width);
  return std::string(what) + " at pixel (" + std::to_string(pixel % columns) + ", " +
         std::to_string(pixel / columns) + ")";
}

std::string got_want(std::uint32_t got, std::uint32_t want) {
  const auto text = [](std::uint32_t id) { return id == background_id ? "background" : std::to_string(id); };
  return ": got " + text(got) + ", want " + text(want);
}

bool is_close(float got, double want, double tolerance) {
  const auto rounded = static_cast<float>(std::min(want, double{std::numeric_limits<float>::max()}));
  const bool beyond_floats = want > double{std::numeric_limits<float>::max()};
  if (beyond_floats) return got >= std::numeric_limits<float>::max();
  if (want < double{std::numeric_limits<float>::min()}) {
    return std::abs(got - rounded) <= std::numeric_limits<float>::denorm_min();
  }
  return std::abs(double{got} / want - 1.0) <= tolerance;
}

bool is_close(double got, const mpq_class& want) {
  if (!std::isfinite(got)) return false;
  const mpq_class error = abs(mpq_class(got) / want - 1);
  return error <= mpq_class(0x1p-39);
}

void check_list(const exact::Fragment* fragment, std::size_t count,
                const std::vector<test::RationalFragment>& want, const std::string& where) {
  require(count == want.size(), where + ": as many fragments as in rational arithmetic");
  for (std::size_t k = 0; k < count; ++k) {
    require(fragment[k].id == want[k].id, where + ": the fragments of rational arithmetic, in order" +
                                              got_want(fragment[k].id, want[k].id));
    require(is_close(fragment[k].depth, want[k].depth), where + ": depth within 2^-39");
    require(fragment[k].tied == (k > 0 && want[k].depth == want[k - 1].depth), where + ": ties are told");
  }
}

}  // namespace

void check_exact_frame(const Frame& frame, const exact::Nearest& nearest, const exact::ExactAnswer& exact,
                       const Algorithm& algorithm) {
  // What is painted last shows, of triangles that are equally near as of others.
  const bool any_of_a_tie = algorithm.traits.paints_faces;
  const double tolerance = algorithm.variant_of.empty() ? 0x1p-23 : 0x1p-19;
  exact::Worker worker = exact.worker();
  for (std::size_t pixel = 0; pixel < frame.pixel_count(); ++pixel) {
    const auto width = static_cast<std::size_t>(frame.width);
    const auto i = static_cast<int>(pixel % width);
    const auto j = static_cast<int>(pixel / width);
    const std::uint32_t got = frame.id[pixel];
    const std::uint32_t want = nearest.id[pixel];
    const bool tied = any_of_a_tie && got != background_id && want != background_id &&
                      worker.covers(got, i, j) && worker.compare_depth(got, want, i, j) == 0;
    require(got == want || tied, at_pixel(pixel, frame.width, algorithm.name) + got_want(got, want));
    if (want == background_id) continue;
    require(is_close(frame.depth[pixel], nearest.depth[pixel], tolerance),
            at_pixel(pixel, frame.width, algorithm.name) + ": depth " + std::to_string(frame.depth[pixel]) +
                ", want " + std::to_string(nearest.depth[pixel]));
  }
}

void check_exact_answer(const exact::ExactAnswer& exact, const exact::Nearest& nearest, const View& view) {
  const test::RationalAnswer rational(view);
  const exact::DepthLists lists = exact.depth_lists(0, view.height);
  for (int j = 0; j < view.height; ++j) {
    for (int i = 0; i < view.width; ++i) {
      const auto pixel =
          static_cast<std::size_t>(j) * static_cast<std::size_t>(view.width) + static_cast<std::size_t>(i);
      const std::string where = at_pixel(pixel, view.width, "exact answer");
      const std::vector<test::RationalFragment> want = rational.depth_list(i, j);
      const std::uint32_t first = want.empty() ? background_id : want.front().id;
      require(nearest.id[pixel] == first, where + got_want(nearest.id[pixel], first));
      if (!want.empty()) require(is_close(nearest.depth[pixel], want.front().depth), where + ": depth");
      check_list(lists.fragments.data() + lists.begin[pixel], lists.begin[pixel + 1] - lists.begin[pixel],
                 want, where);
    }
  }
}

}  // namespace hsr::fuzz
