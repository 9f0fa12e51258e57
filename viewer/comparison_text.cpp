#include <array>
#include <cmath>
#include <cstdio>

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

/// Whole from ten on, two digits below.
std::string rate_text(double number) {
  return number >= 9.5 ? grouped(static_cast<std::uint64_t>(std::llround(number))) : error_text(number);
}

std::vector<std::string> row_of(const Comparison& comparison, const ComparedAlgorithm& compared) {
  const exact::Errors& errors = compared.errors;
  const std::optional<double> per_million = errors_per_million(comparison, compared);
  const std::optional<exact::ListErrors>& lists = compared.lists;
  const bool has_depth = errors.depth.has_value();
  const bool has_color = errors.color.has_value();
  return {compared.algorithm.text(),
          grouped(errors.wrong),
          grouped(errors.holes),
          grouped(errors.leaks),
          per_million ? rate_text(*per_million) : "-",
          lists ? grouped(lists->missing) : "-",
          lists ? grouped(lists->extra) : "-",
          lists ? grouped(lists->inversions) : "-",
          has_depth ? error_text(errors.depth->max) : "-",
          has_depth ? error_text(errors.depth->p99) : "-",
          has_color ? error_text(errors.color->rmse) : "-",
          has_color ? error_text(errors.color->max) : "-",
          three_digits(compared.render_ms)};
}

/// How many pixels fail for which cause, and the pairs with the most, for algorithms where any do.
std::string causes_text(const ComparedAlgorithm& compared) {
  std::string counts;
  for (std::size_t cause = 0; cause < cause_count; ++cause) {
    if (compared.causes[cause] == 0) continue;
    counts += (counts.empty() ? "" : ", ") + std::string(cause_names[cause]) + " " +
              grouped(compared.causes[cause]);
  }
  if (counts.empty()) return {};
  std::string text =
      "\n" + paragraph(compared.algorithm.text() + " fails by cause, in pixels: " + counts + ".");
  for (const FailingPair& pair : compared.worst_pairs) {
    text += definition(
        grouped(pair.pixels),
        sentence(pair) + "; first at pixel " + std::to_string(pair.i) + " " + std::to_string(pair.j), 2, 10);
  }
  return text;
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
    "where nothing is. /million: these three together, for a million covered pixels. lists: fragments that "
    "are missing or are not there in truth, and neighbours of which the first is deeper, for algorithms that "
    "keep lists. depth: relative error of the eye depth where the triangle is right; 99 % of these "
    "pixels are at or below p99. colour: difference in linear RGB, from the exact colour at "
    "the pixel's centre or, for abuffer, from the mean of 32 by 32 exact samples. ms: time to render.";

}  // namespace

std::optional<double> errors_per_million(const Comparison& comparison, const ComparedAlgorithm& compared) {
  if (comparison.covered == 0) return std::nullopt;
  const exact::Errors& errors = compared.errors;
  return 1e6 * static_cast<double>(errors.wrong + errors.holes + errors.leaks) /
         static_cast<double>(comparison.covered);
}

std::string to_text(const Comparison& comparison) {
  TextTable table({"algorithm", "wrong", "holes", "leaks", "/million", "missing", "extra", "inverted", "max",
                   "p99", "rmse", "max", "ms"});
  table.group_columns({{"pixels", 1, 4}, {"lists", 5, 3}, {"depth error", 8, 2}, {"colour error", 10, 2}});
  for (const ComparedAlgorithm& compared : comparison.algorithms) table.add_row(row_of(comparison, compared));
  std::string causes;
  for (const ComparedAlgorithm& compared : comparison.algorithms) causes += causes_text(compared);
  return paragraph(comparison.scene + ", " + counted(comparison.triangles, "triangle") + ", at " +
                   std::to_string(comparison.width) + "x" + std::to_string(comparison.height) + " pixels.") +
         paragraph(exact_answer_text(comparison)) + "\n" + table.text() + "\n" + paragraph(legend) + causes;
}

}  // namespace hsr
