#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hsr {

/// The bytes of a data URI in base64 ("data:...;base64,..."), or nothing if it is not one.
std::optional<std::string> data_uri_bytes(std::string_view uri);

/// A relative URI as a path, with %20 and the like resolved; nothing if it names a scheme ("http:").
std::optional<std::string> uri_path(std::string_view uri);

}  // namespace hsr
