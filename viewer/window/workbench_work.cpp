// What the workbench says of the work that is going on.

#include <algorithm>

#include "window/workbench.h"

namespace hsr::window {

template <class Self, class Visit>
void Workbench::for_each_lane(Self& self, Visit visit) {
  visit("scene", self.model_lane_);
  visit("file", self.file_lane_);
  visit("picture", self.picture_lane_);
  visit("other picture", self.other_lane_);
  visit("exact answer", self.truth_lane_);
  visit("comparison", self.judgement_lane_);
  visit("causes", self.causes_lane_);
  visit("pixel", self.story_lane_);
  visit("steps", self.trace_lane_);
  visit("step", self.moment_lane_);
  visit("marks", self.marks_lane_);
  visit("lists", self.lengths_lane_);
  visit("overdraw", self.overdraw_lane_);
  visit("boxes", self.structure_lane_);
  visit("skips", self.skips_lane_);
  visit("animation", self.gif_lane_);
}

bool Workbench::busy() const {
  bool any = settling_;
  for_each_lane(*this, [&any](const char*, const auto& lane) { any |= lane.busy(); });
  return any;
}

void Workbench::cancel() {
  for_each_lane(*this, [](const char*, auto& lane) { lane.give_up(); });
}

bool Workbench::cancelled() const {
  bool any = false;
  for_each_lane(*this, [&any](const char*, const auto& lane) { any |= lane.has_given_up(); });
  return any;
}

void Workbench::retry() {
  for_each_lane(*this, [](const char*, auto& lane) { lane.retry(); });
}

std::vector<Workbench::Running> Workbench::running() const {
  std::vector<Running> pieces;
  for_each_lane(*this, [&pieces](const char* what, const auto& lane) {
    if (!lane.busy()) return;
    const auto [stage, done] = lane.progress();
    pieces.push_back({what, stage, done, lane.running_ms()});
  });
  return pieces;
}

std::vector<std::string> Workbench::problems() const {
  std::vector<std::string> lines;
  for_each_lane(*this, [&lines](const char*, const auto& lane) {
    const std::string& error = lane.error();
    if (!error.empty() && std::ranges::find(lines, error) == lines.end()) lines.push_back(error);
  });
  return lines;
}

}  // namespace hsr::window
