#include "window/state_text.h"

#include "fuzz/targets.h"
#include "scene/errors.h"

namespace hsr::fuzz {

void state(std::string_view bytes) {
  const std::string source = "a.hsr";
  try {
    const std::string text = window::state_text(window::read_state_text(bytes, source));
    require(window::state_text(window::read_state_text(text, source)) == text,
            "a state that was read is written as the text that reads as the same state");
  } catch (const InputError& error) {
    require(std::string_view(error.what()).starts_with(source + ":"), "an error names the file");
  }
}

}  // namespace hsr::fuzz
