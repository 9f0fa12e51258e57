#pragma once

#include <filesystem>
#include <initializer_list>
#include <string_view>

namespace hsr {

/// Throws UsageError unless the ending of `file` is one of `endings` (".png"), in either case, or it
/// is a device or pipe, which may be called what it likes.
void require_ending(std::string_view option, const std::filesystem::path& file,
                    std::initializer_list<std::string_view> endings);

/// Throws InputError unless `file` is no folder and the folder that it is to stand in exists: better
/// now than after minutes of work.
void require_place(const std::filesystem::path& file);

/// Makes the folder, and those that it stands in, if it is not there. Throws InputError if that fails.
void make_folder(const std::filesystem::path& folder);

}  // namespace hsr
