#pragma once

#include <cstdint>
#include <string_view>

namespace hsr {

/// How a z-buffer stores depth. Each format keeps one number per pixel for which smaller is nearer.
///
/// float32, unorm24 and unorm16 store OpenGL's window depth, near to far as 0 to 1:
/// z = (1 - near / w) far / (far - near). reversed32 stores r = near (far - w) / ((far - near) w),
/// 1 at near and 0 at far, in float32, so that the floats' density round 0 works for the distance;
/// it is kept negated here so that smaller is nearer. eye stores w itself in float32. unrounded keeps w
/// in double.
enum class DepthFormat { unrounded, eye, reversed32, float32, unorm24, unorm16 };

/// The format of a name of the setting "depth" other than "exact".
DepthFormat depth_format(std::string_view name);

/// Rounds depths to a format and back. near_depth and far_depth are those of the view.
class DepthCodec {
 public:
  DepthCodec(DepthFormat format, double near_depth, double far_depth)
      : format_(format), near_(near_depth), far_(far_depth) {}

  /// What is stored for a point at 1 / eye depth, rounded to nearest as the format rounds.
  double stored(double inverse_depth) const;
  /// The eye depth that a stored number stands for.
  double eye_depth(double stored) const;
  /// The most, relative to the true depth, that rounding to the format can move a point at this eye
  /// depth: half a step of the stored number times the slope of eye depth over it, to first order.
  double predicted_error(double eye_depth) const;

 private:
  DepthFormat format_;
  double near_;
  double far_;
};

}  // namespace hsr
