#pragma once

#include <functional>

namespace hsr {

/// Runs body(0) ... body(count - 1), each exactly once, on at most `threads` threads, and returns
/// when all are done. Which thread runs which index is not defined, so a body may only write what
/// belongs to its own index. `threads` is at least 1; with 1 everything runs on the caller, in order.
void parallel_for(int count, int threads, const std::function<void(int)>& body);

}  // namespace hsr
