// The one table of all algorithms. A row is an algorithm's description; adding one takes a folder
// with its sources and a line here.

#include <array>

#include "abuffer/abuffer.h"
#include "abuffer/abuffer_fast.h"
#include "algorithm.h"
#include "depthlist/depthlist.h"
#include "depthlist/depthlist_fast.h"
#include "newell/newell.h"
#include "newell/newell_fast.h"
#include "none/none.h"
#include "painter/painter.h"
#include "painter/painter_fast.h"
#include "raycast/raycast.h"
#include "raycast/raycast_fast.h"
#include "zbuffer/zbuffer.h"
#include "zbuffer/zbuffer_fast.h"

namespace hsr {

std::span<const Algorithm* const> algorithm_catalog() {
  static const std::array rows = {
      &none_algorithm(),         &painter_algorithm(),   &painter_fast_algorithm(),   &newell_algorithm(),
      &newell_fast_algorithm(),  &zbuffer_algorithm(),   &zbuffer_fast_algorithm(),   &abuffer_algorithm(),
      &abuffer_fast_algorithm(), &depthlist_algorithm(), &depthlist_fast_algorithm(), &raycast_algorithm(),
      &raycast_fast_algorithm(),
  };
  return rows;
}

const Algorithm* find_algorithm(std::string_view name) {
  for (const Algorithm* algorithm : algorithm_catalog()) {
    if (algorithm->name == name) return algorithm;
  }
  return nullptr;
}

const Algorithm& default_algorithm() { return zbuffer_fast_algorithm(); }

}  // namespace hsr
