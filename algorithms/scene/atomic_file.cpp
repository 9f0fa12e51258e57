#include "scene/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <random>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "scene/errors.h"

namespace hsr {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail_to_write(const fs::path& file, const std::string& reason) {
  throw InputError("cannot write " + file.string() + ": " + reason);
}

std::string system_reason(int error) { return std::generic_category().message(error); }

/// Whether `file` must be opened where it is: renaming something else to it would not reach the
/// process at the other end. /dev/stdout is here even when it leads to a regular file.
bool must_be_written_in_place(const fs::path& file) {
  const std::string place = fs::absolute(file).lexically_normal().string();
  if (place.starts_with("/dev/") || place.starts_with("/proc/")) {
    return true;
  }
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  return fs::exists(status) && !fs::is_regular_file(status);
}

/// A name that nobody else is likely to use: hidden, and with the ending of `file`.
fs::path temporary_name(const fs::path& file) {
  static constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz0123456789";
  std::random_device random;
  std::uniform_int_distribution<std::size_t> letter(0, letters.size() - 1);
  std::string name = ".hsr-";
  for (int i = 0; i < 12; ++i) {
    name += letters[letter(random)];
  }
  return file.parent_path() / (name + file.extension().string());
}

/// Makes an empty file that did not exist before, with the permissions any new file gets.
fs::path create_temporary_file(const fs::path& file) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    fs::path temporary = temporary_name(file);
    const int descriptor = ::open(temporary.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (descriptor >= 0) {
      ::close(descriptor);
      return temporary;
    }
    if (errno != EEXIST) {
      fail_to_write(file, system_reason(errno));
    }
  }
  fail_to_write(file, "no free name for a temporary file");
}

/// Removes the temporary file at the end, unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& file) : path_(create_temporary_file(file)) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (!path_.empty()) {
      std::error_code ignored;
      fs::remove(path_, ignored);
    }
  }

  const fs::path& path() const { return path_; }

  void rename_to(const fs::path& file) {
    std::error_code error;
    const fs::file_status old = fs::status(file, error);
    if (fs::exists(old)) {
      fs::permissions(path_, old.permissions(), error);  // best effort: another owner's file
    }
    fs::rename(path_, file, error);
    if (error) {
      fail_to_write(file, error.message());
    }
    path_.clear();
  }

 private:
  fs::path path_;
};

/// `text` with every occurrence of `from` replaced by `to`.
std::string replace_all(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

}  // namespace

void write_file_atomically(const fs::path& file,
                           const std::function<void(const fs::path& temporary)>& write) {
  std::error_code error;
  if (file.empty()) {
    throw InputError("cannot write: the file has no name");
  }
  if (fs::is_directory(file, error) || !file.has_filename()) {
    fail_to_write(file, system_reason(EISDIR));
  }
  if (must_be_written_in_place(file)) {
    write(file);
    return;
  }
  if (fs::exists(file, error) && ::access(file.c_str(), W_OK) != 0) {
    fail_to_write(file, system_reason(errno));  // renaming would get round its permissions
  }
  // Through a symbolic link the file behind it is replaced, not the link.
  const bool is_link = fs::is_symlink(file, error);
  const fs::path target = is_link ? fs::weakly_canonical(file, error) : file;
  if (is_link && error) {
    fail_to_write(file, error.message());
  }
  TemporaryFile temporary(target);
  try {
    write(temporary.path());
  } catch (const InputError& failure) {
    throw InputError(replace_all(failure.what(), temporary.path().string(), file.string()));
  }
  temporary.rename_to(target);
}

OutputFile::OutputFile(fs::path file) : file_(std::move(file)), stream_(std::fopen(file_.c_str(), "wb")) {
  if (!stream_) {
    fail();
  }
}

void OutputFile::write(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), stream_.get()) != bytes.size()) {
    fail();
  }
}

void OutputFile::close() {
  if (std::fclose(stream_.release()) != 0) {
    fail();
  }
}

void OutputFile::fail() const { fail_to_write(file_, system_reason(errno)); }

void write_bytes(const fs::path& file, std::string_view bytes) {
  OutputFile output(file);
  output.write(bytes);
  output.close();
}

}  // namespace hsr
