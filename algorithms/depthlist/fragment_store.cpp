#include "depthlist/fragment_store.h"

namespace hsr {

FragmentStore::FragmentStore(const std::vector<Pixel>& pixels, const std::vector<Stored>& stored,
                             std::uint64_t dropped)
    : begin_(pixels.size() + 1), fragments_(stored.size()), dropped_(dropped) {
  for (std::size_t place = 0; place < pixels.size(); ++place) {
    begin_[place + 1] = begin_[place] + pixels[place].count;
  }
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (const Stored& fragment : stored) fragments_[next[fragment.place]++] = {fragment.index, false};
}

}  // namespace hsr
