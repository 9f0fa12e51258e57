#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "window/session.h"

namespace hsr::window {

/// What a script can ask for.
using ScriptValue = std::variant<double, std::string>;

/// The value called `name`, of what is shown now. Throws UsageError for a name that does not exist and
/// InputError for a value that is not there, such as of a pixel where none is selected.
ScriptValue script_value(const Session& session, std::string_view name);

/// Every name.
std::vector<std::string_view> script_value_names();

}  // namespace hsr::window
