#pragma once

#include <memory>

#include "algorithm.h"
#include "bench/contestant.h"

namespace hsr::bench {

/// An algorithm of the kit. Fast versions are asked for ids and depths alone, as other programs are; textbook
/// versions make colours too. The view, and its scene, must outlive it.
std::unique_ptr<Contestant> algorithm_contestant(const AlgorithmSpec& spec, Task task, const View& view,
                                                 const RenderOptions& options);

}  // namespace hsr::bench
