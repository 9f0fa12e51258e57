#include "fuzz/targets.h"
#include "scene/errors.h"
#include "window/script/runner.h"

namespace hsr::fuzz {

void script(std::string_view bytes) {
  const std::string source = "a.hsr-script";
  try {
    window::check_script(bytes, source);
  } catch (const InputError& error) {
    require(std::string_view(error.what()).starts_with(source + ":"), "an error names the file");
  }
}

}  // namespace hsr::fuzz
