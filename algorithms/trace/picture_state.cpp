#include "trace/picture_state.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "view/shading.h"

namespace hsr {

namespace {

float float_depth(double depth) {
  return static_cast<float>(std::min(depth, double{std::numeric_limits<float>::max()}));
}

}  // namespace

PictureState::PictureState(int width, int height, const std::vector<glm::vec4>& colors)
    : colors_(&colors), frame_(width, height), below_(frame_.pixel_count(), glm::vec4(0.0F)) {}

PictureState::Before PictureState::before(const Event& event) const {
  const std::size_t pixel = pixel_of(event);
  return {.pixel = pixel,
          .id = frame_.id[pixel],
          .depth = frame_.depth[pixel],
          .color = frame_.color[pixel],
          .below = below_[pixel],
          .change = Before::Change::picture};
}

PictureState::Before PictureState::change_picture(const Event& event) {
  Before old = before(event);
  const glm::vec4& surface = (*colors_)[event.p];
  show(event);
  frame_.color[old.pixel] = event.blended ? over(surface, old.color) : opaque(surface);
  return old;
}

PictureState::Before PictureState::paint(const Event& event) {
  Before old = before(event);
  show(event);
  if (event.blended) below_[old.pixel] = old.color;
  frame_.color[old.pixel] = over((*colors_)[event.p], below_[old.pixel]);
  return old;
}

PictureState::Before PictureState::store_fragment(const Event& event) {
  if (fragments_ == most_list_fragments) {
    ++fragments_left_out_;
    return {};
  }
  ++fragments_;
  lists_[pixel_of(event)].push_back({event.p, float_depth(event.value), false});
  return {.pixel = pixel_of(event), .change = Before::Change::stored};
}

PictureState::Before PictureState::sort_list(const Event& event) {
  std::vector<ListFragment>& list = lists_[pixel_of(event)];
  Before old = before(event);
  old.change = Before::Change::list;
  old.list = list;
  frame_.color[old.pixel] = glm::vec4(0.0F);
  std::ranges::sort(list, [](const ListFragment& p, const ListFragment& q) {
    return p.depth != q.depth ? p.depth < q.depth : p.id < q.id;
  });
  return old;
}

PictureState::Before PictureState::take_fragment(const Event& event) {
  Before old = before(event);
  const glm::vec4& surface = (*colors_)[event.p];
  glm::vec4& color = frame_.color[old.pixel];
  const bool has_area = event.other > 0.0;
  color = has_area ? color + static_cast<float>(event.other) * surface : over(color, surface);
  if (event.number == 0 && !has_area) show(event);
  return old;
}

void PictureState::show(const Event& event) {
  frame_.id[pixel_of(event)] = event.p;
  frame_.depth[pixel_of(event)] = float_depth(event.value);
}

PictureState::Before PictureState::apply(const Event& event) {
  switch (event.kind) {
    case EventKind::painted:
      return paint(event);
    case EventKind::nearest_replaced:
      return change_picture(event);
    case EventKind::depth_tested:
      return event.passed ? change_picture(event) : Before{};
    case EventKind::edge_drawn: {
      Before old = before(event);
      frame_.color[old.pixel] = edge_ink;
      return old;
    }
    case EventKind::fragment_stored:
      return store_fragment(event);
    case EventKind::list_sorted:
      return sort_list(event);
    case EventKind::fragment_taken:
      return take_fragment(event);
    case EventKind::centre_shown: {
      const Before old = before(event);
      show(event);
      return old;
    }
    default:
      return {};
  }
}

void PictureState::take_back(Before before) {
  switch (before.change) {
    case Before::Change::nothing:
      return;
    case Before::Change::picture:
      frame_.id[before.pixel] = before.id;
      frame_.depth[before.pixel] = before.depth;
      frame_.color[before.pixel] = before.color;
      below_[before.pixel] = before.below;
      return;
    case Before::Change::stored:
      lists_[before.pixel].pop_back();
      --fragments_;
      return;
    case Before::Change::list:
      lists_[before.pixel] = std::move(before.list);
      frame_.color[before.pixel] = before.color;
      return;
  }
}

const std::vector<ListFragment>& PictureState::list(int i, int j) const {
  static const std::vector<ListFragment> none;
  const auto found = lists_.find(frame_.index(i, j));
  return found == lists_.end() ? none : found->second;
}

}  // namespace hsr
