#pragma once

#include <span>
#include <string>
#include <vector>

#include "algorithm.h"
#include "bench/peers.h"

namespace hsr::stress {

/// Who is put to the test: an algorithm of the kit with its settings, or another program.
struct Mode {
  std::string name;
  AlgorithmSpec spec;                      ///< if peer is null
  const bench::PeerEntry* peer = nullptr;  ///< another program, which was built
  bool exact = false;                      ///< promises the exact answer
};

/// Every algorithm with its default settings, and with each other value of each setting that can change
/// which triangle is seen: of a range a few, of parts all but one.
std::vector<Mode> catalogue_modes();

/// The given ones.
std::vector<Mode> modes_of(std::span<const AlgorithmSpec> specs);

/// Other programs that were built, and that answer which triangle is nearest.
std::vector<Mode> peer_modes();

/// Whether the settings leave an exact algorithm exact.
bool promises_exact(const AlgorithmSpec& spec);

}  // namespace hsr::stress
