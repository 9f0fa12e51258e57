#include "scene/readers/format.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "scene/readers/messages.h"
#include "scene/readers/text_lines.h"

namespace hsr {

namespace {

/// How far to look for words that tell a format.
constexpr std::size_t head_bytes = 1U << 16U;

Format format_of_ending(const std::filesystem::path& file) {
  std::filesystem::path name = file.filename();
  if (lower_case(name.extension().string()) == ".gz") {
    name = name.stem();
  }
  const std::string ending = lower_case(name.extension().string());
  return ending == ".obj"    ? Format::obj
         : ending == ".ply"  ? Format::ply
         : ending == ".off"  ? Format::off
         : ending == ".stl"  ? Format::stl_binary
         : ending == ".gltf" ? Format::gltf
         : ending == ".glb"  ? Format::glb
                             : Format::unknown;
}

/// Whether the size is that of a binary STL file with the number of triangles that it would state.
bool has_size_of_stl(std::string_view bytes) {
  if (bytes.size() < 84) {
    return false;
  }
  std::uint64_t count = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    count |= std::uint64_t{static_cast<unsigned char>(bytes[80 + k])} << (8 * k);
  }
  return bytes.size() == 84 + 50 * count;
}

bool is_off_header(std::string_view word) {
  return word.size() <= 7 && word.ends_with("OFF") && std::all_of(word.begin(), word.end() - 3, [](char c) {
           return std::string_view("STCN4n").find(c) != std::string_view::npos;
         });
}

/// Whether a line of the text's head is a vertex as OBJ writes it.
bool looks_like_obj(std::string_view head) {
  TextLines lines(head);
  while (lines.next_line()) {
    float value = 0;
    if (lines.word() == "v" && lines.decimal(value) && lines.decimal(value)) {
      return true;
    }
  }
  return false;
}

Format format_of_text(std::string_view head) {
  TextLines lines(head);
  if (!lines.next_line()) {
    return Format::unknown;
  }
  const std::string_view word = lines.word();
  if (word == "ply") {
    return Format::ply;
  }
  if (is_off_header(word)) {
    return Format::off;
  }
  if (word.starts_with('{')) {
    return Format::gltf;
  }
  const std::string lower = lower_case(std::string(head));
  if (lower_case(std::string(word)) == "solid" &&
      (lower.find("facet") != std::string::npos || lower.find("endsolid") != std::string::npos)) {
    return Format::stl_ascii;
  }
  return looks_like_obj(head) ? Format::obj : Format::unknown;
}

}  // namespace

Format format_of(const std::filesystem::path& file, std::string_view bytes) {
  if (bytes.starts_with("glTF")) {
    return Format::glb;
  }
  if (bytes.starts_with("ply") && bytes.size() > 3 && (bytes[3] <= ' ')) {
    return Format::ply;
  }
  if (has_size_of_stl(bytes)) {
    return Format::stl_binary;
  }
  const std::string_view head = bytes.substr(0, head_bytes);
  const bool is_text_head = head.find('\0') == std::string_view::npos;
  const Format told = is_text_head ? format_of_text(head) : Format::unknown;
  return told != Format::unknown ? told : format_of_ending(file);
}

bool is_text(Format format) {
  return format == Format::obj || format == Format::off || format == Format::stl_ascii;
}

}  // namespace hsr
