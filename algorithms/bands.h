#pragma once

#include <algorithm>

namespace hsr {

/// Rows first ... last - 1 of a picture.
struct Band {
  int first = 0;
  int last = 0;
};

/// A picture cut into horizontal bands, four for each thread so that a crowded one does not hold up
/// the others. Bands are independent, so what is in the frame does not depend on their number.
class Bands {
 public:
  Bands(int height, int threads)
      : height_(height), rows_(std::max(1, (height + 4 * threads - 1) / (4 * threads))) {}

  int count() const { return (height_ + rows_ - 1) / rows_; }
  Band operator[](int index) const { return {index * rows_, std::min((index + 1) * rows_, height_)}; }

 private:
  int height_;
  int rows_;
};

}  // namespace hsr
