#include <array>
#include <cstdio>
#include <optional>

#include "comparison.h"
#include "text_layout.h"

namespace hsr {
namespace {

/// An error to two digits: 0, 0.12, 3.1e-08.
std::string error_text(double error) {
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%.2g", error);
  return text.data();
}

std::vector<std::string> row_of(const ComparedAlgorithm& compared) {
  const exact::Errors& errors = compared.errors;
  const bool has_depth = errors.depth.has_value();
  const bool has_color = errors.color.has_value();
  return {compared.algorithm.text(),
          grouped(errors.wrong),
          grouped(errors.holes),
          grouped(errors.leaks),
          has_depth ? error_text(errors.depth->max) : "-",
          has_depth ? error_text(errors.depth->p99) : "-",
          has_color ? error_text(errors.color->rmse) : "-",
          has_color ? error_text(errors.color->max) : "-",
          milliseconds(compared.render_ms)};
}

std::string exact_answer_text(const Comparison& comparison) {
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(comparison.width) * static_cast<std::uint64_t>(comparison.height);
  const exact::Decisions& decisions = comparison.decisions;
  return "The exact answer: something covers " + grouped(comparison.covered) + " of " +
         counted(pixels, "pixel") + ". It took " + milliseconds(comparison.exact_ms) + " and " +
         counted(decisions.filtered + decisions.integer, "decision") + ": " + grouped(decisions.filtered) +
         " by doubles with a proven bound, " + grouped(decisions.integer) +
         " in whole numbers, where the bound could not settle them.";
}

constexpr const char* legend =
    "wrong: a triangle that is not the nearest. holes: background where something is. leaks: a triangle "
    "where nothing is. depth: relative error of the eye depth where the triangle is right; 99 % of these "
    "pixels are at or below p99. colour: difference in linear RGB.";

}  // namespace

std::string to_text(const Comparison& comparison) {
  TextTable table({"algorithm", "wrong", "holes", "leaks", "max", "p99", "rmse", "max", "time"});
  table.group_columns({{"pixels", 1, 3}, {"depth error", 4, 2}, {"colour error", 6, 2}});
  for (const ComparedAlgorithm& compared : comparison.algorithms) table.add_row(row_of(compared));
  return paragraph(comparison.scene + ", " + counted(comparison.triangles, "triangle") + ", at " +
                   std::to_string(comparison.width) + "x" + std::to_string(comparison.height) + " pixels.") +
         paragraph(exact_answer_text(comparison)) + "\n" + table.text() + "\n" + paragraph(legend);
}

}  // namespace hsr
