#include "exercise.h"

// Pixel by pixel: hidden is what every corner is hidden by.
bool hidden_in_block(const Triangle& triangle, const Block& block) {
  return std::all_of(std::begin(block.depth), std::end(block.depth), [&](double shown) {
    return std::all_of(std::begin(triangle.depth), std::end(triangle.depth),
                       [&](double corner) { return corner > shown; });
  });
}
