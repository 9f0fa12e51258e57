#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace hsr {

/// Runs body(0) ... body(count - 1), each exactly once, on at most `threads` threads, and returns
/// when all are done. Which thread runs which index is not defined, so a body may only write what
/// belongs to its own index. `threads` is at least 1; with 1 everything runs on the caller, in order.
void parallel_for(int count, int threads, const std::function<void(int)>& body);

/// The size of the blocks of parallel_for_blocks: large enough to hide the cost of handing one out.
inline constexpr std::size_t parallel_block = 4096;

/// Runs body(first, last) over blocks that together are 0 ... count - 1, as parallel_for does. The
/// blocks do not depend on the number of threads.
template <class Body>
void parallel_for_blocks(std::size_t count, int threads, Body body) {
  constexpr std::size_t block = parallel_block;
  const auto blocks = static_cast<int>((count + block - 1) / block);
  parallel_for(blocks, threads, [&](int index) {
    const std::size_t first = static_cast<std::size_t>(index) * block;
    body(first, std::min(first + block, count));
  });
}

}  // namespace hsr
