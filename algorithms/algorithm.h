#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "frame/frame.h"
#include "predicates/pixel_box.h"
#include "scene/progress.h"
#include "scene/scene.h"
#include "trace/event.h"
#include "view/view.h"

namespace hsr {

/// A setting of an algorithm. Its value is one of `choices` (the first is the default and the most
/// accurate), or, where `range` is given, a whole number within it, or, where `parts` are given, some
/// of them with + between.
struct Setting {
  struct Range {
    int least;
    int greatest;
  };
  std::string_view name;
  std::string_view meaning;  ///< one sentence
  std::span<const std::string_view> choices;
  std::optional<Range> range = std::nullopt;
  std::span<const std::string_view> parts = {};
};

/// Work that an algorithm leaves out because it cannot change the frame.
struct Skip {
  std::string_view name;
  std::string_view meaning;  ///< one sentence: what is left out, and why that is harmless
};

/// What an algorithm can and cannot do, for tables.
struct Traits {
  std::string_view time;          ///< growth of run time; n triangles, p pixels, d depth complexity
  std::string_view memory;        ///< beyond scene and frame
  std::string_view transparency;  ///< what happens to it
  std::string_view cycles;        ///< what happens where triangles overlap in a cycle or cross
  bool exact;                     ///< equals the exact answer in its default settings
  bool paints_faces = false;      ///< fills Frame::faces
  bool keeps_lists = false;       ///< fills Frame::lists
  bool antialiased = false;       ///< a colour stands for the whole pixel, not for its centre
};

/// A value for every setting of an algorithm, by name.
using Settings = std::map<std::string, std::string, std::less<>>;

/// How a frame is to be made, without any influence on what a pixel shows.
struct RenderOptions {
  int threads = 1;                                    ///< at least 1
  std::set<std::string, std::less<>> skips_off = {};  ///< names of skips not to use
  Progress progress = {};
  std::optional<PixelBox> window = {};  ///< if given, only these pixels are rendered
  /// The instruction set that fast versions use, one of those that the machine has; its best if empty.
  std::string instruction_set = {};

  bool uses(std::string_view skip) const { return !skips_off.contains(skip); }
  /// The same on one thread, as traces need it.
  RenderOptions on_one_thread() const {
    RenderOptions one = *this;
    one.threads = 1;
    return one;
  }
};

/// What was left out and what was done while making a frame.
struct RenderReport {
  std::map<std::string, std::uint64_t, std::less<>> skipped;   ///< by name of the skip
  std::map<std::string, std::uint64_t, std::less<>> counters;  ///< work done, by name
  std::uint64_t bytes = 0;  ///< most memory held at once, beyond scene and frame
};

/// An algorithm with its settings chosen and everything prepared that no camera changes.
/// The scene it was prepared for must outlive it.
class Renderer {
 public:
  virtual ~Renderer() = default;

  /// Fills `frame`, which has the view's size and is all background, with what the view shows.
  /// Keeps nothing that depends on the camera from one call to the next. Does not throw. If the
  /// progress function asks to stop, returns early with an unfinished frame.
  virtual RenderReport render(const View& view, const RenderOptions& options, Frame& frame) = 0;

  /// As render, on one thread, and tells `listener` every step in order. The steps of a view are the
  /// same each time, and the frame is that of render. With a window, steps at other pixels are left
  /// out, and steps that are about no pixel are told all the same.
  virtual RenderReport trace(const View& view, const RenderOptions& options, const EventListener& listener,
                             Frame& frame) = 0;
};

/// One row of the table of algorithms.
struct Algorithm {
  std::string_view name;        ///< as on the command line
  std::string_view title;       ///< as in menus
  std::string_view idea;        ///< one sentence
  std::string_view source;      ///< author, year, section
  std::string_view variant_of;  ///< the textbook version that this one must equal; else empty
  Traits traits;
  std::span<const Setting> settings;
  std::span<const Skip> skips;
  /// Does all work that depends on scene and settings alone.
  std::unique_ptr<Renderer> (*prepare)(const Scene& scene, const Settings& settings,
                                       const RenderOptions& options);
};

/// Every algorithm, in teaching order.
std::span<const Algorithm* const> algorithm_catalog();

/// The row called `name`, or null.
const Algorithm* find_algorithm(std::string_view name);

/// The fastest algorithm that is exact in its default settings.
const Algorithm& default_algorithm();

/// An algorithm and a value for each of its settings.
struct AlgorithmSpec {
  const Algorithm* algorithm = nullptr;
  Settings settings;

  /// As on the command line, with the settings that are not the default: "zbuffer[depth=unorm16]".
  std::string text() const;
};

/// Reads "zbuffer" or "zbuffer[depth=unorm16,snap=4]". Settings not named take their default.
/// Throws UsageError that names what is unknown or out of range and what would be allowed.
AlgorithmSpec parse_algorithm_spec(std::string_view text);

/// Reads a list of specs separated by commas (commas within brackets belong to the spec), or "all":
/// every algorithm with its default settings. Throws UsageError.
std::vector<AlgorithmSpec> parse_algorithm_specs(std::string_view text);

}  // namespace hsr
