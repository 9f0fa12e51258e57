#include "abuffer/pixel_store.h"

namespace hsr {

void PixelStore::sort_by_pixel(const std::vector<Pixel>& pixels, const std::vector<Stored>& stored) {
  begin_.assign(pixels.size() + 1, 0);
  fragments_.resize(stored.size());
  for (std::size_t place = 0; place < pixels.size(); ++place) {
    begin_[place + 1] = begin_[place] + pixels[place].count;
  }
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (const Stored& entry : stored) fragments_[next[entry.place]++] = entry.fragment;
}

}  // namespace hsr
