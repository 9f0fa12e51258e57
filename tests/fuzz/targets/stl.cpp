#include "fuzz/support/run_reader.h"
#include "fuzz/targets.h"
#include "scene/readers/readers.h"

namespace hsr::fuzz {

// Text begins with "solid", as in the format itself; the reader of text is given no NUL.
void stl(std::string_view bytes) {
  if (bytes.starts_with("solid")) {
    run_reader(read_stl_ascii, "fuzz.stl", bytes.substr(0, bytes.find('\0')));
  } else {
    run_reader(read_stl_binary, "fuzz.stl", bytes);
  }
}

}  // namespace hsr::fuzz
