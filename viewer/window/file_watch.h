#pragma once

#include <filesystem>
#include <functional>
#include <thread>

namespace hsr::window {

/// Asks a few times a second whether a file was saved, in a thread of its own, as long as it lives. A file
/// that is not there for a moment, as while an editor replaces it, is waited for.
class FileWatch {
 public:
  /// `saved` is called from that thread whenever the file has another time of writing than before.
  FileWatch(std::filesystem::path file, std::function<void()> saved);
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

 private:
  std::jthread thread_;
};

}  // namespace hsr::window
