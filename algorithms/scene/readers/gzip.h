#pragma once

#include <string>
#include <string_view>

#include "scene/progress.h"

namespace hsr {

/// Whether `bytes` begin as a gzip file does.
bool is_gzip(std::string_view bytes);

/// Inflates a gzip file, of one or several members. Throws InputError with the reason (the caller
/// adds the file's name) when it is broken or cut off, or inflates to more than 16 MiB and more than
/// 100 times its size: no mesh compresses like that, but a file made to fill the memory does.
std::string inflate_gzip(std::string_view bytes, const Progress& progress);

}  // namespace hsr
