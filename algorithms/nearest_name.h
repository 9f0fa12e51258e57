#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hsr {

/// The name among `names` that needs the fewest edits (a character put in, left out or changed) to
/// be made from `word`, if a typing mistake explains the difference: at most two edits, and fewer
/// than half the word's length. Empty otherwise. Of several, the first.
std::string_view nearest_name(std::string_view word, std::span<const std::string_view> names);

/// The end of an error message about an unknown name: what was probably meant, and what there is,
/// as in `; did you mean "zbuffer"? There are: none, painter, zbuffer`.
std::string what_there_is(std::string_view word, std::span<const std::string_view> names);

}  // namespace hsr
