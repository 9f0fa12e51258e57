#pragma once

#include <filesystem>
#include <string>

#include "bench/bench_report.h"

namespace hsr::bench {

/// What a report says, for people: the front of every scene, laws of growth, the table of 1974.
std::string to_text(const BenchReport& report);

/// Writes bench.json, bench.csv, the plots with their data, and index.html, which holds them, into the
/// folder. Returns whether the plots were drawn. Throws InputError.
bool write_report(const BenchReport& report, const std::filesystem::path& folder);

}  // namespace hsr::bench
