#include "window/state_text.h"

#include <algorithm>
#include <set>
#include <span>

#include "nearest_name.h"
#include "scene/atomic_file.h"
#include "scene/errors.h"
#include "text_file.h"
#include "window/state_entries.h"
#include "window/text_lines.h"

namespace hsr::window {
namespace {

constexpr std::string_view heading = "hsr-state";

void read_line(State& state, const TextLine& line, std::set<std::string>& seen) {
  const std::string& name = line.words.front();
  const auto entries = state_entries();
  const auto entry = std::ranges::find(entries, name, &StateEntry::name);
  if (entry == entries.end()) {
    std::vector<std::string_view> names;
    for (const StateEntry& each : entries) names.push_back(each.name);
    throw UsageError("unknown word \"" + name + "\"" + what_there_is(name, names));
  }
  if (line.words.size() != entry->words + 1) {
    throw UsageError("write: " + name + " " + std::string(entry->usage));
  }
  if (!seen.insert(name).second && !entry->repeated) throw UsageError(name + " is given twice");
  entry->read(state, StateWords(line.words).subspan(1));
}

}  // namespace

std::string state_text(const State& state) {
  std::string text = std::string(heading) + " 1\n";
  for (const StateEntry& entry : state_entries()) {
    for (const std::string& line : entry.write(state)) text += std::string(entry.name) + " " + line + "\n";
  }
  return text;
}

State read_state_text(std::string_view text, const std::string& source) {
  const std::vector<TextLine> lines = split_lines(text, source);
  if (lines.empty() || lines[0].words.size() != 2 || lines[0].words[0] != heading) {
    throw InputError(source + ": this is no state of the viewer, which begins with \"hsr-state 1\"");
  }
  if (lines[0].words[1] != "1")
    throw InputError(source + ": a state of version " + lines[0].words[1] + "; this program reads version 1");
  State state;
  std::set<std::string> seen;
  for (const TextLine& line : std::span(lines).subspan(1)) {
    try {
      read_line(state, line, seen);
    } catch (const UsageError& error) {
      throw InputError(source + ":" + std::to_string(line.number) + ": " + error.what());
    }
  }
  return state;
}

State read_state_file(const std::filesystem::path& file) {
  constexpr std::size_t most = 4'000'000;
  return read_state_text(read_text_file(file, most), file.string());
}

void write_state_file(const State& state, const std::filesystem::path& file) {
  write_file_atomically(
      file, [&](const std::filesystem::path& temporary) { write_bytes(temporary, state_text(state)); });
}

}  // namespace hsr::window
