#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "bench/bench_plan.h"
#include "report/table.h"

namespace hsr::bench {

/// What one algorithm did on a scene of so many faces, as the paper of 1974 counted it: in operations, which
/// are the same on every machine, and beside them in time.
///
/// The scene: sheets of triangles, four deep everywhere, which fill a picture of 512 × 512 whatever their
/// number; the file has them in no order. An operation on faces is a comparison of two sort keys, one test of
/// a pair, an exchange or a cut; an operation on pixels is a fragment painted, compared, stored or sorted (a
/// comparison), or a box or triangle that a ray is tested against.
struct Cost1974 {
  std::string_view method;     ///< as the paper calls it
  std::string_view algorithm;  ///< of the kit
  int faces = 0;
  std::map<std::string, std::uint64_t> operations;  ///< by name
  std::uint64_t on_faces = 0;
  std::uint64_t on_pixels = 0;
  double prepare_ms = 0.0;
  double render_ms = 0.0;  ///< least of the repeats, on one thread
  std::string failed;      ///< why there is nothing of the above
};

/// Depth sort (newell), z-buffer, depth lists and ray casting, each in its textbook version.
std::vector<Cost1974> costs_of_1974(int faces, double most_seconds);

/// One line of JSON, and what it was made from.
std::string to_json(const std::vector<Cost1974>& costs);
std::vector<Cost1974> costs_from_json(std::string_view text);

/// Beside each cost what it is relative to that of depth sort at the fewest faces.
report::Table to_table(const std::vector<Cost1974>& costs);

}  // namespace hsr::bench
