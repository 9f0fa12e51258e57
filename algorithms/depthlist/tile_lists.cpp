#include "depthlist/tile_lists.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "depthlist/tile_rows.h"
#include "lanes/filter_bounds.h"
#include "lanes/instruction_sets.h"
#include "view/shading.h"

namespace hsr {

namespace {

// The place of a pixel in a block, and of its block in a tile.
int column_of(std::size_t lane) { return static_cast<int>(lane) % lanes::block_size; }
int row_of(std::size_t lane) { return static_cast<int>(lane) / lanes::block_size; }
std::size_t block_at(int column, int row) {
  return static_cast<std::size_t>(row * lanes::blocks_across + column);
}

}  // namespace

TileLister::TileLister(const TileListing& how)
    : how_(how), instruction_set_(lanes::dispatch_index(how.instruction_set)) {}

lanes::Judge& TileLister::judge() {
  if (!judge_) judge_.emplace(how_.view);
  return *judge_;
}

ListCounts TileLister::total() const {
  ListCounts counts = counts_;
  if (judge_) counts.lanes.lanes_to_exact = judge_->exact_evaluations();
  counts.most_bytes = std::max(counts.most_bytes, (rows_ ? rows_->bytes() : 0) +
                                                      sorted_.entry.capacity() * sizeof(SortedBlock::Lanes));
  return counts;
}

void TileLister::count(int left, int top, std::span<const lanes::TileEntry> entries, std::uint32_t* counts) {
  const ListPart part = {left, top, {}, entries, {}, nullptr, {}};
  draw_rows(instruction_set_, *this, part, RowUse::counted, counts, std::nullopt);
}

void TileLister::list(const ListPart& part, TilePixels& shown) {
  if (!rows_) rows_.emplace(wants_lists());
  rows_->clear();
  draw_rows(instruction_set_, *this, part, wants_lists() ? RowUse::kept_by_depth : RowUse::kept, nullptr,
            std::nullopt);
  if (rows_->overflowed()) {
    if (part.blocks.single()) return list_pixel_by_pixel(part, shown);
    for (const bool second : {false, true}) {
      ListPart half = part;
      half.blocks = part.blocks.half(second);
      list(half, shown);
    }
    return;
  }
  std::vector<BlockRange> deep;
  std::vector<BlockRange> anew;
  for (int row = part.blocks.first_y; row <= part.blocks.last_y; ++row) {
    for (int column = part.blocks.first_x; column <= part.blocks.last_x; ++column) {
      const Finish finish = finish_block(part, column, row, shown);
      if (finish == Finish::too_many_rows) deep.push_back({column, column, row, row});
      if (finish == Finish::hidden_may_be_seen) anew.push_back({column, column, row, row});
    }
  }
  ListPart block = part;
  for (const BlockRange& blocks : deep) {
    block.blocks = blocks;
    list_pixel_by_pixel(block, shown);
  }
  block.opaque = nullptr;
  for (const BlockRange& blocks : anew) {
    block.blocks = blocks;
    list(block, shown);
  }
}

// Every triangle that covers some of the block is in the rows: sort, settle and hand out its 16 lists.
TileLister::Finish TileLister::finish_block(const ListPart& part, int column, int row, TilePixels& shown) {
  const std::size_t block = block_at(column, row);
  const auto rows = static_cast<std::uint32_t>(rows_->count(block));
  if (rows > SortedBlock::most_rows) return Finish::too_many_rows;
  if (rows == 0 && part.opaque == nullptr) return Finish::done;
  sort_block(instruction_set_, *rows_, block,
             part.opaque != nullptr ? part.opaque->inverse_depth + block * row_lanes : nullptr, sorted_);
  if (sorted_.levels == 0) return Finish::done;
  slots_.resize(std::max<std::size_t>(slots_.size(), rows + std::size_t{1}));
  for (std::uint32_t slot = 0; slot < rows; ++slot) {
    const std::uint32_t id = rows_->id(sorted_.row_of[slot]);
    slots_[slot] = {id, wants_lists() ? rows_->depth(sorted_.row_of[slot]) : nullptr, how_.colors[id]};
  }
  for (std::size_t lane = 0; lane < row_lanes; ++lane) {
    const int i = part.left + column * lanes::block_size + column_of(lane);
    const int j = part.top + row * lanes::block_size + row_of(lane);
    if (i < part.box.first_i || i > part.box.last_i || j < part.box.first_j || j > part.box.last_j) continue;
    if (sorted_.at(0, lane) == SortedBlock::nothing) continue;
    if (part.opaque != nullptr) {
      const std::uint32_t id = part.opaque->id[block * row_lanes + lane];
      slots_[rows] = {id, nullptr, id == background_id ? glm::vec4(0.0F) : how_.colors[id]};
    }
    if ((sorted_.open >> lane & 1U) != 0U && !settle_lane(lane, i, j)) return Finish::hidden_may_be_seen;
    write_lane(part, block, lane, how_.frame.index(i, j), shown);
  }
  return Finish::done;
}

// False if an opaque surface behind which others were left out counts for nothing, as it ties with a
// transparent one of lower id.
bool TileLister::settle_lane(std::size_t lane, int i, int j) {
  counts_.lanes.lanes_to_double +=
      ties_.settle_lane(sorted_, lane, centre_a(how_.view.width, i), centre_b(how_.view.height, j), judge(),
                        [&](std::uint32_t slot) { return slots_[slot].id; });
  for (std::uint32_t rank = 0; rank < sorted_.count(lane); ++rank) {
    const std::uint32_t entry = sorted_.at(rank, lane);
    const bool tied = (entry & SortedBlock::tied_bit) != 0U;
    if (tied && sorted_.row_of[entry & SortedBlock::slot_mask] == FragmentRows::none) return false;
  }
  return true;
}

// Hands out the sorted list of a pixel of a block.
void TileLister::write_lane(const ListPart& part, std::size_t block, std::size_t lane, std::size_t pixel,
                            TilePixels& shown) {
  const std::uint32_t* entry = &sorted_.at(0, lane);  // every 16th is the lane's
  const std::uint32_t ties = (sorted_.open >> lane & 1U) != 0U ? SortedBlock::tied_bit : 0U;
  const std::size_t place = block * row_lanes + lane;
  const std::uint32_t nearest = entry[0] & SortedBlock::slot_mask;
  const std::uint32_t nearest_row = sorted_.row_of[nearest];
  shown.id[place] = slots_[nearest].id;
  shown.inverse_depth[place] = nearest_row == FragmentRows::none ? part.opaque->inverse_depth[place]
                                                                 : rows_->inverse_depth(nearest_row)[lane];
  if (!how_.frame.color.empty()) {
    glm::vec4 color(0.0F);
    for (std::uint32_t rank = 0; rank < sorted_.levels; ++rank) {
      const std::uint32_t here = entry[rank * row_lanes];
      if (here == SortedBlock::nothing) break;
      if ((here & ties) != 0U) continue;
      const glm::vec4& surface = slots_[here & SortedBlock::slot_mask].color;
      color = over(color, surface);
      if (surface.a >= 1.0F) break;
    }
    how_.frame.color[pixel] = color;
  }
  if (wants_lists()) {
    FragmentLists& lists = *how_.frame.lists;
    ListFragment* to = lists.fragments.data() + lists.begin[pixel];
    const ListFragment* end = lists.fragments.data() + lists.begin[pixel + 1];
    for (; to != end; ++to, entry += row_lanes) {
      const Slot& slot = slots_[*entry & SortedBlock::slot_mask];
      *to = {slot.id, slot.depth[lane], (*entry & ties) != 0U};
    }
  }
}

// Hands out the list of a pixel that was made by itself.
void TileLister::write_lone(std::size_t place, std::size_t pixel, TilePixels& shown) {
  shown.id[place] = lone_.front().id;
  shown.inverse_depth[place] = lone_.front().inverse_depth;
  if (!how_.frame.color.empty()) {
    glm::vec4 color(0.0F);
    for (const LoneFragment& fragment : lone_) {
      if (fragment.tied) continue;
      const glm::vec4& surface = how_.colors[fragment.id];
      color = over(color, surface);
      if (surface.a >= 1.0F) break;
    }
    how_.frame.color[pixel] = color;
  }
  if (wants_lists()) {
    FragmentLists& lists = *how_.frame.lists;
    ListFragment* to = lists.fragments.data() + lists.begin[pixel];
    for (const LoneFragment& fragment : lone_) *to++ = {fragment.id, fragment.depth, fragment.tied};
  }
}

// A single block of so many triangles that they do not fit into the rows: each pixel has its list made by
// itself, of all that covers it.
void TileLister::list_pixel_by_pixel(ListPart part, TilePixels& shown) {
  part.opaque = nullptr;
  const int column = part.blocks.first_x;
  const int row = part.blocks.first_y;
  const RowUse use = wants_lists() ? RowUse::kept_by_depth : RowUse::kept;
  for (std::size_t lane = 0; lane < row_lanes; ++lane) {
    const int i = part.left + column * lanes::block_size + column_of(lane);
    const int j = part.top + row * lanes::block_size + row_of(lane);
    if (i < part.box.first_i || i > part.box.last_i || j < part.box.first_j || j > part.box.last_j) continue;
    lone_.clear();
    lone_error_ = 0.0F;
    rows_->clear();
    draw_rows(instruction_set_, *this, part, use, nullptr, static_cast<int>(lane));
    counts_.most_bytes =
        std::max(counts_.most_bytes, rows_->bytes() + lone_.capacity() * sizeof(LoneFragment));
    if (lone_.empty()) continue;
    settle_lone(i, j);
    write_lone(block_at(column, row) * row_lanes + lane, how_.frame.index(i, j), shown);
  }
}

void TileLister::settle_lone(int i, int j) {
  std::ranges::sort(lone_, [](const LoneFragment& p, const LoneFragment& q) {
    return p.inverse_depth != q.inverse_depth ? p.inverse_depth > q.inverse_depth : p.id < q.id;
  });
  const double apart = 2.0 * double{lone_error_} * double{lanes::comparison_slack};
  std::size_t end = 0;
  std::vector<LoneFragment> sorted;
  for (std::size_t first = 0; first < lone_.size(); first = end) {
    for (end = first + 1; end < lone_.size(); ++end) {
      if (double{lone_[end - 1].inverse_depth} - double{lone_[end].inverse_depth} > apart) break;
    }
    if (end - first == 1) continue;
    uncertain_.clear();
    sorted.clear();
    for (std::size_t rank = first; rank < end; ++rank) {
      uncertain_.push_back({lone_[rank].id, static_cast<std::uint32_t>(rank), false});
    }
    counts_.lanes.lanes_to_double += end - first;
    ties_.sort(uncertain_, centre_a(how_.view.width, i), centre_b(how_.view.height, j), judge());
    for (const UncertainFragment& fragment : uncertain_) {
      sorted.push_back(lone_[fragment.payload]);
      sorted.back().tied = fragment.tied;
    }
    std::ranges::copy(sorted, lone_.begin() + static_cast<std::ptrdiff_t>(first));
  }
}

ListCounts& ListCounts::operator+=(const ListCounts& other) {
  lanes += other.lanes;
  fragments += other.fragments;
  hidden += other.hidden;
  no_lists += other.no_lists;
  most_bytes = std::max(most_bytes, other.most_bytes);
  return *this;
}

}  // namespace hsr
