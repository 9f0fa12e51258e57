#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "exact/errors.h"
#include "exact/exact_answer.h"
#include "failures/ordering_failures.h"
#include "window/results/rendered.h"

namespace hsr::window {

/// The exact answer of a view.
struct Truth {
  std::shared_ptr<const Scene> scene;
  View view;
  std::shared_ptr<const exact::ExactAnswer> answer;
  exact::Nearest nearest;
  Frame frame;  ///< the answer as a picture: the lowest id of the nearest, colours by the exact lists
  ScreenPicture screen;
  double milliseconds = 0.0;
};

Truth find_truth(const ViewKey& key, const Surroundings& given, const Progress& progress);

/// What is to be said of one pixel of a picture.
enum class Verdict : std::uint8_t { right, wrong, hole, leak };

/// A picture held against the exact answer.
struct Judgement {
  exact::Errors errors;
  std::vector<Verdict> verdicts;      ///< per pixel, row by row
  std::vector<std::uint32_t> failed;  ///< the pixels whose triangle is not right, row by row

  /// Whether a colour differs visibly from that of the exact lists.
  bool colors_differ() const {
    return errors.color && errors.color->max > static_cast<double>(visible_difference);
  }
};

/// Why the wrong pixels are wrong. `key` made the picture.
OrderingFailures find_causes(const PictureKey& key, const Surroundings& given, const Rendered& rendered,
                             const Truth& truth, const Progress& progress);

Judgement judge(const Rendered& rendered, const Truth& truth, const Progress& progress);

}  // namespace hsr::window
