#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "scene/scene.h"
#include "trace/event.h"

namespace hsr {

/// Where a picture was seen from.
struct ToldView {
  Camera camera;
  double near_depth = 0.0;  ///< scene units, as is far_depth
  double far_depth = 0.0;

  bool operator==(const ToldView& other) const {
    return camera.eye == other.camera.eye && camera.target == other.camera.target &&
           camera.up == other.camera.up && camera.vertical_fov_degrees == other.camera.vertical_fov_degrees &&
           near_depth == other.near_depth && far_depth == other.far_depth;
  }
};

/// A picture that another process made, and what it tells of it.
struct ToldPicture {
  Frame frame;  ///< ids and depths always; colours and lists if they were told
  std::optional<ToldView> view;
  std::vector<Event> steps;  ///< of the whole run, in order
  bool tells_steps = false;
};

// The stream is one line
//
//   hsr-picture 1 WIDTH HEIGHT
//
// and then sections, each a line "NAME BYTES" and after it exactly so many bytes; the last is "end 0".
// Whole numbers are of 32 bits, fractions floats of 32 bits, the least byte first. Pixels go row by row
// from the top left.
//
//   id      a primitive id for each pixel, 4294967295 for background; must be there
//   depth   eye depth for each pixel, of any value for background; must be there
//   color   red, green, blue, opacity for each pixel: linear, premultiplied
//   lists   for each pixel how many fragments it has; then of each fragment id, eye depth, and 1 if it is
//           exactly as deep as the one before it in its list, else 0
//   camera  as text, with spaces between: eye, target, up (three numbers each), vertical field of view in
//           degrees, near and far
//   steps   a line for each, as in trace/event_json.h

/// Writes the picture: colours, lists and view where it has them, steps if tells_steps. Frame::faces are
/// not told. The stream's state says whether all was taken.
void write_picture_stream(const ToldPicture& picture, std::ostream& stream);

/// What a reader takes at most, so that no stream fills the memory.
struct PictureLimits {
  std::uint32_t triangles = 0;  ///< of the scene: ids are below
  int size = 8192;              ///< pixels, of width and of height
  std::size_t fragments = 100'000'000;
  std::size_t steps = 5'000'000;
};

/// Reads what such a stream tells. Memory grows with what was read, not with what is claimed. Depths of
/// background pixels become infinite. Throws InputError that begins with `name` for anything that is no
/// such picture: cut off, too large, an id that is no triangle, a depth that is no number, a step at a
/// pixel outside of the picture.
ToldPicture read_picture_stream(std::istream& stream, const std::string& name, const PictureLimits& limits);

}  // namespace hsr
