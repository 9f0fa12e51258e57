#pragma once

#include <string_view>

namespace hsr {

/// OBJ has no word for "no material from here on": our writer gives this name, which no library
/// defines, and our reader takes it, where no library defines it, to mean just that.
inline constexpr std::string_view obj_no_material = "no_material";

}  // namespace hsr
