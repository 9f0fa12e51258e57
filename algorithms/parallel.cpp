#include "parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cassert>

namespace hsr {

void parallel_for(int count, int threads, const std::function<void(int)>& body) {
  assert(threads >= 1);
  if (threads == 1) {
    for (int index = 0; index < count; ++index) body(index);
    return;
  }
  // An arena of the wanted size, as the number of threads is the user's to choose, whatever the
  // machine has.
  tbb::task_arena arena(threads);
  arena.execute([&] { tbb::parallel_for(0, count, body, tbb::simple_partitioner()); });
}

}  // namespace hsr
