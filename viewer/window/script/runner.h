#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>

namespace hsr::window {

class App;
struct State;

/// What of a script is done, and where.
struct ScriptManner {
  bool expectations = true;  ///< and what is printed
  bool screenshots = true;
  std::filesystem::path folder = {};  ///< where screenshots go
};

/// Does what a script says, a line after the other, by events of the kind that a person's hands make.
/// Throws InputError with file and line at the first line that is wrong or whose expectation fails. Commands
/// and the number of their words are checked before anything is done. Of a file that ends in .md the blocks
/// marked hsr-script are done, one after the other.
void run_script(App& app, const std::filesystem::path& file, std::ostream& out);

/// The same for the text of a script; `source` is named in messages. Returns the number of its lines.
std::size_t run_script_text(App& app, std::string_view text, const std::string& source,
                            const ScriptManner& manner, std::ostream& out);

/// The scripts in a lesson's Markdown, all other lines empty, so that lines keep their numbers.
std::string script_blocks(std::string_view markdown);

/// Sets what a script sets in the end, and passes over all that it does, looks at or measures. Throws
/// InputError.
void set_as_script(State& state, std::string_view text, const std::string& source);

/// Checks the commands of a script and the number of their words, as run_script does before it begins.
/// `source` is named in messages. Throws InputError with source and line.
void check_script(std::string_view text, const std::string& source);

}  // namespace hsr::window
