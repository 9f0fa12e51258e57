#include "zbuffer/depth_format.h"

#include <algorithm>
#include <cmath>

namespace hsr {

namespace {

constexpr double steps24 = 16777215.0;  // 2^24 - 1
constexpr double steps16 = 65535.0;     // 2^16 - 1

double to_unorm(double z, double steps) { return std::nearbyint(std::clamp(z, 0.0, 1.0) * steps); }

}  // namespace

DepthFormat depth_format(std::string_view name) {
  if (name == "eye") return DepthFormat::eye;
  if (name == "reversed32") return DepthFormat::reversed32;
  if (name == "float32") return DepthFormat::float32;
  return name == "unorm24" ? DepthFormat::unorm24 : DepthFormat::unorm16;
}

double DepthCodec::stored(double inverse_depth) const {
  const double window = (1.0 - near_ * inverse_depth) * far_ / (far_ - near_);
  switch (format_) {
    case DepthFormat::unrounded:
      return 1.0 / inverse_depth;
    case DepthFormat::eye:
      return static_cast<float>(1.0 / inverse_depth);
    case DepthFormat::reversed32:
      return -static_cast<float>(near_ * (far_ * inverse_depth - 1.0) / (far_ - near_));
    case DepthFormat::float32:
      return static_cast<float>(window);
    case DepthFormat::unorm24:
      return to_unorm(window, steps24);
    case DepthFormat::unorm16:
      return to_unorm(window, steps16);
  }
  return window;
}

double DepthCodec::eye_depth(double stored) const {
  const auto from_window = [&](double z) { return near_ * far_ / (far_ - z * (far_ - near_)); };
  switch (format_) {
    case DepthFormat::unrounded:
    case DepthFormat::eye:
      return stored;
    case DepthFormat::reversed32:
      return near_ * far_ / (near_ - stored * (far_ - near_));
    case DepthFormat::float32:
      return from_window(stored);
    case DepthFormat::unorm24:
      return from_window(stored / steps24);
    case DepthFormat::unorm16:
      return from_window(stored / steps16);
  }
  return stored;
}

double DepthCodec::predicted_error(double eye_depth) const {
  constexpr double half_step_of_float = 0x1p-24;  // relative to the number that is rounded
  // |dw / w| for a step dz of window depth: w = n f / (f - z (f - n)), so dw = w² (f - n) / (n f) dz.
  const double slope = eye_depth * (far_ - near_) / (near_ * far_);
  const double window = (1.0 - near_ / eye_depth) * far_ / (far_ - near_);
  switch (format_) {
    case DepthFormat::unrounded:
      return 0.0;
    case DepthFormat::eye:
      return half_step_of_float;
    case DepthFormat::reversed32:
      return slope * (1.0 - window) * half_step_of_float;
    case DepthFormat::float32:
      return slope * window * half_step_of_float;
    case DepthFormat::unorm24:
      return slope * 0.5 / steps24;
    case DepthFormat::unorm16:
      return slope * 0.5 / steps16;
  }
  return 0.0;
}

}  // namespace hsr
