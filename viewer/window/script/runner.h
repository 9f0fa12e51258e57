#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>

namespace hsr::window {

class App;

/// Does what a script says, a line after the other, by events of the kind that a person's hands make.
/// Throws InputError with file and line at the first line that is wrong or whose expectation fails. Commands
/// and the number of their words are checked before anything is done. Of a file that ends in .md the blocks
/// marked hsr-script are done, one after the other.
void run_script(App& app, const std::filesystem::path& file, std::ostream& out);

/// Checks the commands of a script and the number of their words, as run_script does before it begins.
/// `source` is named in messages. Throws InputError with source and line.
void check_script(std::string_view text, const std::string& source);

}  // namespace hsr::window
