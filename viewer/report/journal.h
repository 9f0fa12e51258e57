#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace hsr::report {

/// Results of a long run, kept in a file as they come, so that a run that is stopped goes on where it was:
/// a line of JSON each, {"key": ..., "value": ...}, after a first line that says what the run is.
class Journal {
 public:
  /// Takes over what `file` has if its first line says `run`, a text such as the options and the machine;
  /// else begins anew. A last line that is cut off counts for nothing. Throws InputError.
  Journal(std::filesystem::path file, const std::string& run);

  /// The value of a key, as JSON.
  std::optional<std::string> find(const std::string& key) const;
  /// Adds a value, which is JSON without line breaks, and writes it out. Throws InputError.
  void add(const std::string& key, const std::string& json);
  /// How many values an earlier run left.
  std::size_t taken_over() const { return taken_over_; }
  /// Removes the file, once everything is written elsewhere.
  void finish();

 private:
  std::filesystem::path file_;
  std::map<std::string, std::string> values_;
  std::size_t taken_over_ = 0;
};

}  // namespace hsr::report
