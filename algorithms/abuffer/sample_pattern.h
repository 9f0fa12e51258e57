#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hsr {

/// Where the samples of a pixel lie, the same in every pixel.
///
/// With N samples, the pixel is divided into N columns and N rows, and every column and every row has
/// one sample in its middle: sample k lies in column k and in the row that the table names, counted
/// from the pixel's upper left corner, at
///
///   x = (k + 1/2) / N,  y = (row + 1/2) / N.
///
///    N   rows of columns 0 ... N - 1
///    1   0
///    4   2 0 3 1
///    8   1 5 3 7 0 4 2 6
///   16   12 4 8 0 14 6 10 2 13 5 9 1 15 7 11 3
///   32   24 8 16 0 28 12 20 4 26 10 18 2 30 14 22 6 25 9 17 1 29 13 21 5 27 11 19 3 31 15 23 7
///
/// The row is k with its binary digits reversed, exclusive-or 0, 2, 1, 12 or 24, so each pattern is a
/// digital net (Hammersley 1960; Kollig and Keller 2002): whichever way the pixel is divided into N
/// equal rectangles with sides that are powers of two, each has one sample. The 32 samples thus fill
/// Carpenter's 4 × 8 cells. The number for the exclusive-or is the one for which a straight edge at a
/// random place and angle is answered best; the error of 32 samples is then 13 times below that of one.
class SamplePattern {
 public:
  static constexpr std::size_t most_samples = 32;

  /// `count` is 1, 4, 8, 16 or 32.
  explicit SamplePattern(std::size_t count);

  std::size_t size() const { return size_; }
  /// The bits of all samples.
  std::uint32_t full() const { return static_cast<std::uint32_t>((std::uint64_t{1} << size_) - 1); }
  /// What is to be added to the sample coordinates of the pixel's centre (predicates/homogeneous.h) to
  /// get those of a sample. Coordinates and sums are whole multiples of 2^-5: exact.
  double a(std::size_t sample) const { return a_[sample]; }
  double b(std::size_t sample) const { return b_[sample]; }
  /// No sample lies farther from the centre, to the right, left, above or below, in pixels.
  double reach() const { return 0.5 - 0.5 / static_cast<double>(size_); }

 private:
  std::size_t size_;
  std::array<double, most_samples> a_{};
  std::array<double, most_samples> b_{};
};

}  // namespace hsr
