#include "window/file_watch.h"

#include <system_error>

namespace hsr::window {

std::optional<FileWatch::Stamp> FileWatch::stamp_of(const std::string& file) {
  std::error_code no_time;
  std::error_code no_size;
  const Stamp stamp = {std::filesystem::last_write_time(file, no_time),
                       std::filesystem::file_size(file, no_size)};
  return no_time || no_size ? std::nullopt : std::optional(stamp);
}

bool FileWatch::changed(const std::string& file) {
  const auto now = std::chrono::steady_clock::now();
  if (file != file_) {
    file_ = file;
    told_ = last_ = stamp_of(file);
    looked_ = now;
    return false;
  }
  if (std::chrono::duration<double>(now - looked_).count() < interval) return false;
  looked_ = now;
  const std::optional<Stamp> stamp = stamp_of(file);
  const bool rests = stamp && stamp == last_;
  last_ = stamp;
  if (!rests || stamp == told_) return false;
  told_ = stamp;
  return true;
}

}  // namespace hsr::window
