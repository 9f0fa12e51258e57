#pragma once

#include <string>

namespace hsr {

/// The catalogues in full, as JSON.
std::string scenes_json();
std::string algorithms_json();
std::string settings_json();

}  // namespace hsr
