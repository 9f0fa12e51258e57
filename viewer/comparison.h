#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "algorithm.h"
#include "exact/errors.h"
#include "exact/exact_answer.h"
#include "exact/list_errors.h"
#include "failures/ordering_failures.h"

namespace hsr {

/// One algorithm's picture of a view, held against the exact answer.
struct ComparedAlgorithm {
  AlgorithmSpec algorithm;
  exact::Errors errors;
  std::optional<exact::ListErrors> lists;           ///< where it keeps lists
  std::array<std::uint64_t, cause_count> causes{};  ///< wrong pixels and wrong blends, by cause
  std::vector<FailingPair> worst_pairs;             ///< those with the most pixels
  double prepare_ms = 0.0;
  double render_ms = 0.0;
};

/// What `hsr compare` found out.
struct Comparison {
  std::string scene;
  std::size_t triangles = 0;
  int width = 0;
  int height = 0;
  std::uint64_t covered = 0;   ///< pixels whose centre something covers
  exact::Decisions decisions;  ///< how the exact answer was reached
  double exact_ms = 0.0;
  std::vector<ComparedAlgorithm> algorithms;
};

/// Pixels with an error of any kind for each million that something covers; nothing if none is.
std::optional<double> errors_per_million(const Comparison& comparison, const ComparedAlgorithm& compared);

/// As a table with what it means, for people.
std::string to_text(const Comparison& comparison);

/// In full. A measure that does not apply is null.
std::string to_json(const Comparison& comparison);

}  // namespace hsr
