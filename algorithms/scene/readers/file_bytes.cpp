#include "scene/readers/file_bytes.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <system_error>

#include "scene/errors.h"
#include "scene/readers/gzip.h"
#include "scene/readers/messages.h"

namespace hsr {

namespace fs = std::filesystem;

namespace {

struct Closer {
  void operator()(std::FILE* stream) const { (void)std::fclose(stream); }
};

[[noreturn]] void fail(const fs::path& file, std::string_view reason) {
  throw InputError(place_message(file.string(), {}, reason));
}

std::uint64_t half_of_memory() {
  const long pages = ::sysconf(_SC_PHYS_PAGES);
  const long page = ::sysconf(_SC_PAGESIZE);
  return pages > 0 && page > 0 ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page) / 2
                               : std::uint64_t{1} << 32U;
}

/// The most that is read from a pipe or device, which might never end.
constexpr std::uint64_t greatest_stream = std::uint64_t{1} << 30U;

/// The size that the system tells, as a hint: pipes and devices have none.
std::uint64_t size_hint(const fs::path& file) {
  std::error_code error;
  const std::uintmax_t size = fs::is_regular_file(file, error) ? fs::file_size(file, error) : 0;
  return error ? 0 : size;
}

}  // namespace

std::string raw_file_bytes(const fs::path& file, const Progress& progress) {
  std::error_code error;
  if (fs::is_directory(file, error)) {
    fail(file, "is a folder, not a file");
  }
  const std::unique_ptr<std::FILE, Closer> stream(std::fopen(file.c_str(), "rb"));
  if (!stream) {
    fail(file, std::generic_category().message(errno));
  }
  const std::uint64_t expected = size_hint(file);
  const std::uint64_t limit = expected > 0 ? half_of_memory() : std::min(half_of_memory(), greatest_stream);
  std::string bytes;
  std::size_t filled = 0;
  for (;;) {
    if (filled > limit || expected > limit) {
      fail(file, expected > 0 ? "is larger than half of this machine's memory"
                              : "gives more than 1 GiB: only a file that knows its size may be larger");
    }
    constexpr std::size_t least_room = 1U << 16U;
    if (bytes.size() - filled < least_room) {
      bytes.resize(filled < expected ? expected + least_room : 2 * filled + least_room);
    }
    // Steps of a few megabytes, so that a long read can be seen and stopped.
    const std::size_t step = std::min<std::size_t>(bytes.size() - filled, 1U << 23U);
    const std::size_t count = std::fread(bytes.data() + filled, 1, step, stream.get());
    filled += count;
    if (count < step) {
      if (std::ferror(stream.get()) != 0) {
        fail(file, std::generic_category().message(errno));
      }
      break;
    }
    if (!report_progress(progress, "reading", 0.0)) {
      fail(file, "interrupted");
    }
  }
  bytes.resize(filled);
  return bytes;
}

std::string file_bytes(const fs::path& file, const Progress& progress) {
  std::string bytes = raw_file_bytes(file, progress);
  if (!is_gzip(bytes)) {
    return bytes;
  }
  try {
    return inflate_gzip(bytes, progress);
  } catch (const InputError& error) {
    fail(file, error.what());
  }
}

}  // namespace hsr
