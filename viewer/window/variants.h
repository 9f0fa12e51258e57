#pragma once

#include <vector>

#include "algorithm.h"

namespace hsr::window {

/// The textbook algorithms, in the order of the catalogue: what the buttons and the number keys choose from.
std::vector<const Algorithm*> textbook_algorithms();

/// The textbook version of a fast one; any other algorithm itself.
const Algorithm& textbook_of(const Algorithm& algorithm);

/// The fast version of an algorithm, or of its textbook version; null if there is none.
const Algorithm* fast_version_of(const Algorithm& algorithm);

/// The fast version with the same settings, where there is one and it knows all of them that are not the
/// default; otherwise the spec itself. What buttons and keys choose.
AlgorithmSpec quickest_version(const AlgorithmSpec& spec);

/// The version whose steps are told for a picture of the spec: the textbook's.
AlgorithmSpec telling_version(const AlgorithmSpec& spec);

/// The textbook version for a fast one and the other way round, with the settings that both have. The spec
/// itself where there is no fast version.
AlgorithmSpec other_version(const AlgorithmSpec& spec);

}  // namespace hsr::window
