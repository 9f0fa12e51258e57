#pragma once

#include <cstdint>
#include <vector>

#include "exact/exact_answer.h"
#include "scene/progress.h"
#include "view/view.h"

namespace hsr {

/// Which triangle has to be painted before which, as the exact depth lists of a picture demand it: of
/// two neighbours in a list the farther before the nearer. (Between others it follows.) If the demands
/// have no cycle, there is an order of whole triangles that is right at every pixel's centre.
class DepthOrderGraph {
 public:
  /// Reads the depth lists of the whole picture. Where several triangles are painted as a whole, `stands_for`
  /// has for each id one of those that it is painted with, the same for all of them; else it is empty.
  DepthOrderGraph(const View& view, const exact::ExactAnswer& exact, int threads, const Progress& progress,
                  std::vector<std::uint32_t> stands_for = {});

  /// The shortest cycle with `later` painted directly before `sooner`: triangles that each have to be
  /// painted before the next and the last before the first, beginning with `sooner` and ending with
  /// `later`; of those between that are painted as a whole, one is named. Empty if there is none.
  std::vector<std::uint32_t> cycle(std::uint32_t sooner, std::uint32_t later) const;

 private:
  void find_components();
  std::uint32_t node(std::uint32_t id) const { return stands_for_.empty() ? id : stands_for_[id]; }

  std::vector<std::uint32_t> stands_for_;
  std::vector<std::uint64_t> demands_;    // farther id << 32 | nearer id, sorted, each once
  std::vector<std::size_t> begin_;        // by farther id: where its demands begin
  std::vector<std::uint32_t> component_;  // by id: equal within a cycle of any length
};

}  // namespace hsr
