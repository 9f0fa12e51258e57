#include "bench/algorithm_contestant.h"

#include <algorithm>
#include <limits>

#include "picture.h"

namespace hsr::bench {
namespace {

class AlgorithmContestant : public Contestant {
 public:
  AlgorithmContestant(const AlgorithmSpec& spec, Task task, const View& view, const RenderOptions& options)
      : spec_(spec), task_(task), view_(view), options_(options) {
    const bool fast = !spec.algorithm->variant_of.empty();
    frame_ = fast ? Frame::without_colors(view.width, view.height) : Frame(view.width, view.height);
    const Stopwatch stopwatch;
    renderer_ = prepared();
    prepare_ms_ = stopwatch.milliseconds();
  }

  double run() override {
    make_background();
    if (task_ == Task::lists && !frame_.lists) frame_.lists.emplace();
    const Stopwatch stopwatch;
    if (task_ == Task::prepare_and_nearest) renderer_ = prepared();
    (void)renderer_->render(view_, options_, frame_);
    return stopwatch.milliseconds();
  }

  Frame picture() override {
    Frame ids_and_depths = Frame::without_colors(view_.width, view_.height);
    ids_and_depths.id = frame_.id;
    ids_and_depths.depth = frame_.depth;
    return ids_and_depths;
  }

  double prepare_ms() const override { return prepare_ms_; }

 private:
  std::unique_ptr<Renderer> prepared() const {
    return spec_.algorithm->prepare(*view_.scene, spec_.settings, options_);
  }

  // As the contract of render asks; the memory is there and warm, as in a viewer that draws frame after
  // frame.
  void make_background() {
    std::ranges::fill(frame_.color, glm::vec4(0.0F));
    std::ranges::fill(frame_.depth, std::numeric_limits<float>::infinity());
    std::ranges::fill(frame_.id, background_id);
  }

  AlgorithmSpec spec_;
  Task task_;
  const View& view_;
  RenderOptions options_;
  Frame frame_;
  std::unique_ptr<Renderer> renderer_;
  double prepare_ms_ = 0.0;
};

}  // namespace

std::unique_ptr<Contestant> algorithm_contestant(const AlgorithmSpec& spec, Task task, const View& view,
                                                 const RenderOptions& options) {
  return std::make_unique<AlgorithmContestant>(spec, task, view, options);
}

}  // namespace hsr::bench
