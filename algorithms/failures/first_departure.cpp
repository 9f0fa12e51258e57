#include "failures/first_departure.h"

namespace hsr {

namespace {

std::uint64_t place_of(const Event& event) {
  return std::uint64_t{static_cast<std::uint32_t>(event.j)} << 32U | static_cast<std::uint32_t>(event.i);
}

void lose(std::optional<Departure>& lost, const Event& event, std::uint64_t step) {
  if (!lost) lost = {step, event};
}

}  // namespace

// p takes the place of q.
void DepartureFinder::show(Pixel& pixel, const Event& event, std::uint64_t step) {
  pixel.shown = event.p;
  if (admissible(event, event.p)) {
    pixel.lost.reset();
  } else if (admissible(event, event.q)) {
    lose(pixel.lost, event, step);
  }
}

void DepartureFinder::tell(const Event& event, std::uint64_t step) {
  if (event.i < 0 || event.p == background_id) return;
  Pixel& pixel = pixels_[place_of(event)];
  switch (event.kind) {
    case EventKind::painted:
    case EventKind::nearest_replaced:
      show(pixel, event, step);
      return;
    case EventKind::depth_tested:
      if (event.passed) {
        show(pixel, event, step);
      } else if (admissible(event, event.p) && !admissible(event, event.q)) {
        lose(pixel.lost, event, step);
      }
      return;
    // A triangle that the ray meets is lost as well unless it becomes the nearest next.
    case EventKind::triangle_tested:
    case EventKind::fragment_dropped:
      if (admissible(event, event.p) && !admissible(event, pixel.shown)) lose(pixel.lost, event, step);
      return;
    case EventKind::fragment_taken:
      if (event.number == 0 && event.other == 0.0) show(pixel, event, step);
      return;
    case EventKind::centre_shown:
      show(pixel, event, step);
      return;
    default:
      return;
  }
}

std::optional<Departure> DepartureFinder::first() const {
  std::optional<Departure> first;
  for (const auto& [place, pixel] : pixels_) {
    if (!pixel.lost || pixel.lost->step == 0) continue;
    if (admissible(pixel.lost->event, pixel.shown)) continue;
    if (!first || pixel.lost->step < first->step) first = pixel.lost;
  }
  return first;
}

}  // namespace hsr
