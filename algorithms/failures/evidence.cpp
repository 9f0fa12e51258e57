#include "failures/evidence.h"

#include <algorithm>
#include <cstddef>

namespace hsr {

namespace {

PixelBox enclosing(const std::vector<WrongPixel>& wrong) {
  PixelBox box = {wrong.front().i, wrong.front().i, wrong.front().j, wrong.front().j};
  for (const WrongPixel& pixel : wrong) {
    box.first_i = std::min(box.first_i, pixel.i);
    box.last_i = std::max(box.last_i, pixel.i);
    box.first_j = std::min(box.first_j, pixel.j);
    box.last_j = std::max(box.last_j, pixel.j);
  }
  return box;
}

class Listener {
 public:
  Listener(const View& view, const std::vector<WrongPixel>& wrong, AllEvidence& all)
      : width_(view.width),
        wrong_(wrong),
        place_(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height), background_id),
        all_(all) {
    for (std::uint32_t place = 0; place < wrong.size(); ++place) {
      place_[pixel(wrong[place].i, wrong[place].j)] = place;
    }
  }

  void listen(const Event& event) {
    if (event.kind == EventKind::key_given) all_.keys[event.p] = event.value;
    if (event.i < 0 || place_[pixel(event.i, event.j)] == background_id) return;
    const std::uint32_t place = place_[pixel(event.i, event.j)];
    Evidence& evidence = all_.pixels[place];
    const bool about_nearest = event.p == wrong_[place].nearest;
    switch (event.kind) {
      case EventKind::depth_tested:
      case EventKind::nearest_replaced:
        evidence.compared_depths = true;
        evidence.met_nearest = evidence.met_nearest || about_nearest;
        break;
      case EventKind::triangle_tested:
        evidence.compared_depths = true;
        evidence.met_nearest = evidence.met_nearest || (about_nearest && event.passed);
        break;
      case EventKind::painted:
      case EventKind::fragment_stored:
        evidence.met_nearest = evidence.met_nearest || about_nearest;
        break;
      case EventKind::fragment_dropped:
        if (about_nearest && event.q == background_id) evidence.list_was_full = true;
        break;
      default:
        break;
    }
  }

 private:
  std::size_t pixel(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(i);
  }

  int width_;
  const std::vector<WrongPixel>& wrong_;
  std::vector<std::uint32_t> place_;  // per pixel: index into the wrong ones, or background_id
  AllEvidence& all_;
};

}  // namespace

AllEvidence gather_evidence(const View& view, const AlgorithmSpec& spec, const RenderOptions& options,
                            const std::vector<WrongPixel>& wrong, const RendererMaker& maker) {
  AllEvidence all;
  all.pixels.resize(wrong.size());
  if (wrong.empty()) return all;
  Listener listener(view, wrong, all);
  RenderOptions of_wrong_pixels = options;
  // A wrong comparison can be the reason that a box behind it was not opened: open them all.
  for (const Skip& skip : spec.algorithm->skips) of_wrong_pixels.skips_off.insert(std::string(skip.name));
  of_wrong_pixels.window = enclosing(wrong);
  Frame frame(view.width, view.height);
  const auto renderer = maker ? maker() : spec.algorithm->prepare(*view.scene, spec.settings, options);
  renderer->trace(
      view, of_wrong_pixels,
      [&](const Event& event) {
        all.heard = true;
        listener.listen(event);
      },
      frame);
  return all;
}

}  // namespace hsr
