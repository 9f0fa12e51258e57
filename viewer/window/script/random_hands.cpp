#include <array>
#include <random>

#include "scene/catalog.h"
#include "window/script/hands.h"

namespace hsr::window {
namespace {

constexpr std::array keys = {
    "1",   "2",      "3",       "4",          "5",      "6",      "7",      "8",       "9",       "c",
    "o",   "n",      "z",       "v",          "r",      "p",      "space",  "l",       "t",       "F1",
    "tab", "escape", "left",    "right",      "up",     "down",   "home",   "end",     "x",       "f",
    "[",   "]",      ",",       ".",          "/",      "return", "w",      "a",       "s",       "d",
    "q",   "e",      "Shift+N", "Shift+left", "Ctrl+C", "Ctrl+V", "Ctrl+-", "Shift+X", "Shift+,", "Shift+."};
/// Small ones, so that there is time for many events.
constexpr std::array scenes = {"three-bars",   "crossing",  "box",        "glass",
                               "coplanar",     "layers:40", "soup:200",   "needles:40:60",
                               "degenerate:2", "teapot:2",  "hair-apart", "no-such-scene"};

}  // namespace

void Hands::anything(int events, unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&random](std::size_t count) { return static_cast<int>(random() % count); };
  const auto any_x = [&] { return below(1400) - 40; };
  const auto any_y = [&] { return below(900) - 40; };
  // Several events come between two pictures, as from a person in a hurry.
  frames_after_event_ = 0;
  int done = 0;
  while (done < events && !app_.session().quit) {
    const int kind = below(100);
    if (kind < 40) {
      key(keys[static_cast<std::size_t>(below(keys.size()))]);
      done += 2;
    } else if (kind < 65) {
      click(any_x(), any_y(), static_cast<Uint8>(SDL_BUTTON_LEFT + below(3)));
      done += 3;
    } else if (kind < 80) {
      drag(any_x(), any_y(), any_x(), any_y(), static_cast<Uint8>(SDL_BUTTON_LEFT + below(3)));
      done += 11;
    } else if (kind < 90) {
      move(any_x(), any_y());
      wheel(below(9) - 4);
      done += 2;
    } else if (kind < 94) {
      type(below(2) == 0 ? "so" : "1e9#");
      done += 1;
    } else if (kind < 97) {
      app_.window().resize({640 + below(900), 400 + below(600)});
      done += 1;
    } else {
      drop(scenes[static_cast<std::size_t>(below(scenes.size()))]);
      done += 1;
    }
    frames(1);
  }
  frames_after_event_ = 2;
}

}  // namespace hsr::window
