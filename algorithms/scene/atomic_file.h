#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>

namespace hsr {

/// Makes `file` whole or not at all: calls `write` with the path of an empty temporary file in the
/// same folder and, when it returns, renames that to `file`. The temporary name keeps the ending.
/// If `write` throws, the temporary file is removed, what stood at `file` stays as it was, and the
/// exception goes on; where an InputError's text names the temporary file, it names `file` instead.
///
/// A file that exists keeps its permissions, a symbolic link its place. A pipe or device that
/// exists, and everything below /dev and /proc, is handed to `write` directly. Throws InputError
/// when the folder does not exist, `file` is a directory, or the system refuses.
void write_file_atomically(const std::filesystem::path& file,
                           const std::function<void(const std::filesystem::path& temporary)>& write);

/// A file that is written piece by piece. Every failure throws InputError with the file's name and
/// the system's reason.
class OutputFile {
 public:
  /// Opens `file` and empties it.
  explicit OutputFile(std::filesystem::path file);

  void write(std::string_view bytes);

  /// Flushes and closes. Must be called before the end, as only then it is known that the system
  /// has taken every byte.
  void close();

 private:
  struct Closer {
    void operator()(std::FILE* stream) const { (void)std::fclose(stream); }
  };
  [[noreturn]] void fail() const;

  std::filesystem::path file_;
  std::unique_ptr<std::FILE, Closer> stream_;
};

/// Writes `bytes` as the whole content of `file`, not atomically: meant for use within
/// write_file_atomically. Throws InputError.
void write_bytes(const std::filesystem::path& file, std::string_view bytes);

}  // namespace hsr
