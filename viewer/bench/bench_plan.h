#pragma once

#include <string>
#include <vector>

#include "algorithm.h"
#include "bench/bench_options.h"
#include "bench/peers.h"
#include "bench/run_record.h"
#include "bench/timing.h"
#include "values.h"

namespace hsr::bench {

/// Who is to run.
struct Entry {
  AlgorithmSpec spec;               ///< of the kit; its algorithm is null for a peer
  const PeerEntry* peer = nullptr;  ///< or another program
  int threads = 1;
  std::string skip_off = {};  ///< a skip that is not to be used

  std::string name() const { return peer != nullptr ? std::string(peer->name) : spec.text(); }
};

/// One scene at one size, and all who run on it in turn.
struct Cell {
  Question question = Question::tradeoff;
  std::string scene;
  Size size;
  double parameter = 0.0;  ///< as in RunRecord
  std::vector<Entry> entries;
  /// Whether depth lists are held against the exact ones, and antialiased pictures against 32 × 32 samples,
  /// both of which take long.
  bool all_errors = false;
};

struct BenchPlan {
  std::vector<Cell> cells;
  RepeatLimits limits;
  double most_seconds = 10.0;      ///< a run that takes longer is stopped
  std::vector<int> faces_of_1974;  ///< for the table of 1974; empty: left out
  int all_threads = 1;
};

/// Everything that the command asks for. Throws UsageError for an unknown question.
BenchPlan make_plan(const BenchCommand& command);

/// The algorithm with every setting at its default, then with each other value of each setting alone. Of a
/// range of numbers: the least, and its double three times over; of parts: all without each of them.
std::vector<AlgorithmSpec> with_each_setting(const Algorithm& algorithm);

/// The measured scene whose number of triangles and whose depth complexity are chosen.
std::string sheets_scene(int triangles, int depth);

}  // namespace hsr::bench
