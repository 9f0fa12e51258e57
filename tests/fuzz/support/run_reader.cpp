#include "fuzz/support/run_reader.h"

#include "fuzz/support/check_scene.h"
#include "fuzz/targets.h"

namespace hsr::fuzz {

void check_message(std::string_view message) {
  require(!message.empty() && message.size() < 2000, "a message is not empty and not endless");
  for (const char c : message) {
    require(static_cast<unsigned char>(c) >= ' ', "a message is one line of printable characters");
  }
}

void run_reader(Scene (*reader)(const Input&), const std::filesystem::path& file, std::string_view bytes) {
  const Progress nobody;
  Warnings warnings(file.string());
  try {
    check_scene(reader(Input{file, bytes, nobody, warnings}));
  } catch (const InputError& error) {
    check_message(error.what());
  }
  for (const std::string& line : warnings.lines()) check_message(line);
}

}  // namespace hsr::fuzz
