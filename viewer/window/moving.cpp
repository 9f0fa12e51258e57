#include "window/moving.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "window/scene_words.h"

namespace hsr::window {

void move_parameter(Session& session, double seconds) {
  constexpr double period = 8.0;
  if (session.moving_parameter < 0) return;
  SceneWords words(session.bench.state.scene);
  const auto place = static_cast<std::size_t>(session.moving_parameter);
  if (words.entry() == nullptr || place >= words.values().size()) {
    session.moving_parameter = -1;
    return;
  }
  session.moving_phase = std::fmod(session.moving_phase + seconds / period, 1.0);
  if (!session.bench.picture_is_current()) return;
  const SceneParameter& parameter = words.entry()->parameters[place];
  // From half its default to twice that, within its range.
  const double least = std::max(parameter.least, parameter.default_value / 2.0);
  const double greatest = std::min(parameter.greatest, parameter.default_value * 2.0);
  const double part = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * session.moving_phase);
  double value = least + part * (greatest - least);
  if (parameter.whole) value = std::round(value);
  if (value == words.values()[place]) return;
  words.values()[place] = value;
  session.bench.state.scene = words.text();
  session.bench.state.moved.clear();
}

}  // namespace hsr::window
