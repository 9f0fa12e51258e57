#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/timing.h"
#include "exact/errors.h"
#include "exact/list_errors.h"
#include "report/table.h"

namespace hsr::bench {

/// What a run is for: which question of hsr bench it answers.
enum class Question {
  tradeoff,   ///< time against error, on ordinary scenes
  triangles,  ///< growth with the number of triangles
  pixels,     ///< ... of pixels
  depth,      ///< ... of surfaces at a pixel
};
inline constexpr std::string_view question_names[] = {"tradeoff", "triangles", "pixels", "depth"};
constexpr std::string_view name_of(Question question) {
  return question_names[static_cast<std::size_t>(question)];
}

/// Everything about one algorithm or peer on one scene: how long it took and how right it was.
struct RunRecord {
  Question question = Question::tradeoff;
  std::string scene;  ///< as on the command line
  std::uint64_t triangles = 0;
  int width = 0;
  int height = 0;
  std::uint64_t covered = 0;  ///< pixels whose centre something covers
  double parameter = 0.0;     ///< what grows: triangles, pixels, or surfaces at a pixel; else 0

  std::string name;       ///< with settings that are not the default: "zbuffer[depth=eye]"
  std::string algorithm;  ///< without settings
  bool peer = false;
  bool only_geometry = false;  ///< makes ids and depths, and no colours, while its time is taken
  int threads = 1;
  std::string skip_off;  ///< a skip that was not used; empty: all were

  std::string failed;  ///< why there are no times; then nothing below need be there
  double load_ms = 0.0;
  double prepare_ms = 0.0;
  Timing render;
  bool settled = false;  ///< the spread of the times is known and small
  std::uint64_t bytes = 0;
  std::map<std::string, std::uint64_t, std::less<>> skipped;
  std::map<std::string, std::uint64_t, std::less<>> counters;
  std::optional<exact::Errors> errors;
  std::optional<exact::ListErrors> lists;

  /// Tells this run from all others of a report.
  std::string key() const;
  /// Pixels that are wrong, holes or leaks.
  std::uint64_t wrong_pixels() const;
  /// The same for each million that something covers; nothing where that cannot be said.
  std::optional<double> errors_per_million() const;
};

/// One line of JSON, and what it was made from. Throws InputError if it is not of that form.
std::string to_json(const RunRecord& record);
RunRecord record_from_json(std::string_view text);

/// A row for each run.
report::Table to_table(const std::vector<RunRecord>& records);

}  // namespace hsr::bench
