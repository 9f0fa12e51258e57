#include "parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <cassert>
#include <thread>
#include <vector>

namespace hsr {
namespace {

#ifdef __SANITIZE_THREAD__
// The thread sanitizer does not see how TBB's library synchronizes and would report every loop.
// Under it plain threads run the bodies, which are what is to be checked.
void run_parallel(int count, int threads, const std::function<void(int)>& body) {
  std::atomic<int> next = 0;
  const auto work = [&] {
    for (int index = next++; index < count; index = next++) body(index);
  };
  std::vector<std::jthread> helpers;
  for (int helper = 1; helper < threads; ++helper) helpers.emplace_back(work);
  work();
}
#else
// The number of threads is the user's to choose, whatever the machine has: hence an arena of that
// size, and the control, without which TBB stops at the number of cores and prints a warning.
void run_parallel(int count, int threads, const std::function<void(int)>& body) {
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  arena.execute([&] { tbb::parallel_for(0, count, body, tbb::simple_partitioner()); });
}
#endif

}  // namespace

void parallel_for(int count, int threads, const std::function<void(int)>& body) {
  assert(threads >= 1);
  if (threads == 1) {
    for (int index = 0; index < count; ++index) body(index);
  } else {
    run_parallel(count, threads, body);
  }
}

}  // namespace hsr
