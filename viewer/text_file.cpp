#include "text_file.h"

#include <fstream>

#include "scene/errors.h"

namespace hsr {

std::string read_text_file(const std::filesystem::path& file, std::size_t most) {
  std::error_code ignored;
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file, ignored)) {
    throw InputError(file.string() + ": cannot be read");
  }
  std::string text;
  constexpr std::size_t block = 65536;
  do {
    const std::size_t size = text.size();
    text.resize(size + block);
    stream.read(text.data() + size, block);
    text.resize(size + static_cast<std::size_t>(stream.gcount()));
    if (text.size() > most) throw InputError(file.string() + ": too large for a text of this kind");
  } while (stream);
  if (stream.bad()) throw InputError(file.string() + ": cannot be read to its end");
  return text;
}

}  // namespace hsr
