#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "scene/errors.h"
#include "scene/progress.h"
#include "scene/readers/messages.h"

namespace hsr {

/// What every reader is given: the whole content of a file, decompressed, and whom to tell.
struct Input {
  std::filesystem::path file;  ///< as the user wrote it; files it names are looked for beside it
  std::string_view bytes;
  const Progress& progress;
  Warnings& warnings;

  [[noreturn]] void fail(const Place& place, std::string_view text) const {
    throw InputError(place_message(warnings.file(), place, text));
  }
};

/// Tells the progress of a reader about every megabyte and throws InputError if it is to stop.
class ReadProgress {
 public:
  explicit ReadProgress(const Input& input) : input_(input) {}

  /// To be called often: `offset` bytes are done.
  void at(std::size_t offset) {
    if (offset >= next_) {
      tell(offset);
    }
  }

 private:
  void tell(std::size_t offset) {
    next_ = offset + (std::size_t{1} << 20U);
    const double part = static_cast<double>(offset) / static_cast<double>(input_.bytes.size());
    if (!report_progress(input_.progress, "reading", part)) {
      input_.fail({}, "interrupted");
    }
  }

  const Input& input_;
  std::size_t next_ = 0;
};

}  // namespace hsr
