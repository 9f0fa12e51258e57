#pragma once

#include <string>
#include <string_view>

namespace hsr {

/// A text as it stands in HTML, between elements or in a quoted attribute.
std::string html_text(std::string_view text);

}  // namespace hsr
