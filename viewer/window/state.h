#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "algorithm.h"
#include "scene/scene.h"

namespace hsr::window {

/// How the picture is held against another one.
enum class Comparing : std::uint8_t { off, wiper, side_by_side, blink, difference };

/// What is drawn over the picture.
enum class Overlay : std::uint8_t { none, errors, list_length, depth, face, color_error, overdraw };

/// Whose steps are shown: all, or those at the selected pixel, or those about the face that it shows.
enum class StepsOf : std::uint8_t { all, pixel, face };

/// Colours of the interface.
enum class Theme : std::uint8_t { dark, light };

/// A corner that was dragged: its index in Scene::positions and where it is now, in the world.
struct MovedCorner {
  std::uint32_t corner = 0;
  glm::vec3 position{0.0F};
  bool operator==(const MovedCorner&) const = default;
};

/// A picture that is not made here.
struct Elsewhere {
  enum class Kind : std::uint8_t { file, command };
  Kind kind = Kind::file;
  std::string words;     ///< the file's name, or what the shell is to run for each view
  bool allowed = false;  ///< whether somebody here asked for the command; never so in a state that was read
  bool operator==(const Elsewhere&) const = default;
};

/// Width and height of a picture in pixels, or of the window.
struct Extent {
  int width = 0;
  int height = 0;
  bool operator==(const Extent&) const = default;
};

/// How deep the boxes of a hierarchy can be shown from outside.
inline constexpr int most_outside_level = 20;

/// All that a person chose in the viewer, so all that makes up what is seen: a state written to a file
/// and read again shows the same.
struct State {
  std::string scene = "three-bars";  ///< as on the command line
  std::vector<MovedCorner> moved;
  std::optional<Camera> camera;   ///< nothing: the scene's own
  std::optional<Extent> picture;  ///< nothing: as large as its panel

  AlgorithmSpec algorithm = parse_algorithm_spec(default_algorithm().name);
  std::set<std::string, std::less<>> skips_off;
  std::optional<Elsewhere> elsewhere;  ///< a picture from another process ...
  bool show_elsewhere = false;         ///< ... in place of the algorithm's

  Comparing comparing = Comparing::off;
  std::optional<AlgorithmSpec> other;  ///< what is compared with; nothing: the exact answer
  float wiper = 0.5F;                  ///< where the divider stands, from 0 (left) to 1 (right)

  std::optional<glm::ivec2> pixel;  ///< the selected one: column and row
  float magnification = 1.0F;       ///< of the picture, relative to where it fits its panel
  glm::vec2 centre{0.5F};           ///< of the magnified part, from 0 to 1 in the picture
  Overlay overlay = Overlay::none;
  bool log_depth = false;  ///< of the plot of a pixel's fragments
  bool check = true;       ///< holds every picture against the exact answer

  bool stepping = false;            ///< shows the algorithm's steps and the picture after step `step`
  std::uint64_t step = 0;           ///< how many steps are done
  float speed = 10.0F;              ///< steps a second when playing
  StepsOf steps_of = StepsOf::all;  ///< which steps

  Theme theme = Theme::dark;
  std::optional<Extent> window;  ///< its size, where it was told
  float scale = 0.0F;            ///< of the interface; 0: as the display asks
  bool lecture = false;
  bool outside = false;                  ///< the second view, from outside
  std::optional<Camera> outside_camera;  ///< nothing: from the side and above
  int outside_level = 3;                 ///< how deep the boxes of a hierarchy are shown there

  int lesson = 0;             ///< the lesson that is open, from 1; 0: none
  int lesson_step = 1;        ///< its step, from 1
  bool lesson_aside = false;  ///< the settings stand in its place
};

/// Another scene, from its own camera.
void set_scene(State& state, const std::string& words);
void set_algorithm(State& state, const AlgorithmSpec& spec);

/// The names of the values, as in state files and scripts; in the order of the enumeration.
std::span<const std::string_view> comparing_names();
std::span<const std::string_view> overlay_names();
std::span<const std::string_view> theme_names();
std::span<const std::string_view> steps_of_names();

}  // namespace hsr::window
