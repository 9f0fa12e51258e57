#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace hsr::window {

/// Notices that a file has changed: looks now and then, and tells of a change once the file has stayed the
/// same from one look to the next, so that it is not read half written. A file that is gone is none.
class FileWatch {
 public:
  /// Seconds between two looks.
  static constexpr double interval = 0.25;

  /// Whether `file` has changed since it was first asked for, or since the last change that was told. With
  /// another name it begins anew.
  bool changed(const std::string& file);
  void stop() { file_.clear(); }

 private:
  struct Stamp {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    bool operator==(const Stamp&) const = default;
  };
  static std::optional<Stamp> stamp_of(const std::string& file);

  std::string file_;
  std::chrono::steady_clock::time_point looked_;
  std::optional<Stamp> told_;
  std::optional<Stamp> last_;
};

}  // namespace hsr::window
