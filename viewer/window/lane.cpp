#include "window/lane.h"

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace hsr::window {

void step_back() {
#ifdef __linux__
  // There, priorities are those of threads.
  constexpr int niceness = 10;
  (void)setpriority(PRIO_PROCESS, 0, niceness);
#endif
}

}  // namespace hsr::window
