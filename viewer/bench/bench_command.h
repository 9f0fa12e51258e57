#pragma once

#include <iosfwd>

#include "bench/bench_options.h"

namespace hsr::bench {

/// hsr bench without --speed: run time against error, growth, skips, structures and the table of 1974.
void run_bench(const BenchCommand& command, std::ostream& out);

/// hsr bench --compare. Throws InputError if something became slower or more wrong, after saying what.
void run_comparison(const BenchCommand& command, std::ostream& out);

}  // namespace hsr::bench
