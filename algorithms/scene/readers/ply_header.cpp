#include "scene/readers/ply_header.h"

#include <array>
#include <optional>
#include <utility>

#include "scene/readers/text_lines.h"

namespace hsr {

namespace {

std::optional<PlyType> type_named(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, PlyType>, 16> names{
      {{"char", PlyType::int8},
       {"int8", PlyType::int8},
       {"uchar", PlyType::uint8},
       {"uint8", PlyType::uint8},
       {"short", PlyType::int16},
       {"int16", PlyType::int16},
       {"ushort", PlyType::uint16},
       {"uint16", PlyType::uint16},
       {"int", PlyType::int32},
       {"int32", PlyType::int32},
       {"uint", PlyType::uint32},
       {"uint32", PlyType::uint32},
       {"float", PlyType::float32},
       {"float32", PlyType::float32},
       {"double", PlyType::float64},
       {"float64", PlyType::float64}}};
  for (const auto& [known, type] : names) {
    if (known == name) {
      return type;
    }
  }
  return std::nullopt;
}

/// Where the line "end_header" ends, its line end included; npos if there is no such line.
std::size_t find_end(std::string_view bytes) {
  constexpr std::string_view keyword = "end_header";
  for (std::size_t at = bytes.find(keyword); at != std::string_view::npos; at = bytes.find(keyword, at + 1)) {
    std::size_t before = at;
    while (before > 0 && TextLines::is_blank(bytes[before - 1])) {
      --before;
    }
    if (before == 0 || (bytes[before - 1] != '\n' && bytes[before - 1] != '\r')) {
      continue;
    }
    // Exactly one line end, of the header's kind: the next byte may look like one and be data.
    const bool ends_with_cr = bytes.substr(0, at).find('\n') == std::string_view::npos;
    std::size_t end = at + keyword.size();
    while (end < bytes.size() && TextLines::is_blank(bytes[end])) {
      ++end;
    }
    if (end < bytes.size() && bytes[end] == '\r') {
      ++end;
    }
    if (!ends_with_cr && end < bytes.size() && bytes[end] == '\n') {
      ++end;
    }
    return end;
  }
  return std::string_view::npos;
}

class HeaderReader {
 public:
  HeaderReader(const Input& input, std::string_view text) : input_(input), lines_(text) {}

  PlyHeader read() {
    lines_.next_line();  // "ply"
    while (lines_.next_line()) {
      const std::string_view keyword = lines_.word();
      if (keyword == "format") {
        read_format();
      } else if (keyword == "element") {
        read_element();
      } else if (keyword == "property") {
        read_property();
      } else if (keyword == "end_header") {
        header_.body_line = lines_.line() + 1;
      } else if (keyword != "comment" && keyword != "obj_info") {
        fail("unknown word " + in_quotes(keyword) + " in the header");
      }
    }
    if (!has_format_) {
      input_.fail({}, "the header names no format");
    }
    return std::move(header_);
  }

 private:
  Place place() const { return Place::line(lines_.line()); }
  [[noreturn]] void fail(const std::string& text) const { input_.fail(place(), text); }

  void read_format() {
    const std::string_view name = lines_.word();
    using Format = PlyHeader::Format;
    if (name == "ascii") {
      header_.format = Format::ascii;
    } else if (name == "binary_little_endian") {
      header_.format = Format::binary_little_endian;
    } else if (name == "binary_big_endian") {
      header_.format = Format::binary_big_endian;
    } else {
      fail("unknown format " + in_quotes(name));
    }
    has_format_ = true;
  }

  void read_element() {
    PlyElement element;
    element.name = lines_.word();
    element.place = place();
    std::int64_t rows = 0;
    if (element.name.empty() || !lines_.whole(rows) || rows < 0) {
      fail("an element needs a name and a number of rows");
    }
    element.rows = static_cast<std::uint64_t>(rows);
    header_.elements.push_back(std::move(element));
  }

  PlyType read_type() {
    const std::string_view name = lines_.word();
    const std::optional<PlyType> type = type_named(name);
    if (!type) {
      fail("unknown type " + in_quotes(name));
    }
    return *type;
  }

  void read_property() {
    if (header_.elements.empty()) {
      fail("property before any element");
    }
    PlyProperty property;
    TextLines ahead = lines_;
    property.is_list = ahead.word() == "list";
    if (property.is_list) {
      lines_ = ahead;
      property.count_type = read_type();
      if (property.count_type == PlyType::float32 || property.count_type == PlyType::float64) {
        fail("the length of a list must be of a whole type");
      }
    }
    property.type = read_type();
    property.name = lines_.word();
    if (property.name.empty()) {
      fail("property without a name");
    }
    header_.elements.back().properties.push_back(std::move(property));
  }

  const Input& input_;
  TextLines lines_;
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      break;
  }
  return 8;
}

std::size_t PlyElement::least_row_bytes() const {
  std::size_t sum = 0;
  for (const PlyProperty& property : properties) {
    sum += size_of(property.is_list ? property.count_type : property.type);
  }
  return sum;
}

PlyHeader read_ply_header(const Input& input) {
  if (!input.bytes.starts_with("ply") && !input.bytes.starts_with("\xEF\xBB\xBFply")) {
    input.fail({}, "not a PLY file: it does not begin with 'ply'");
  }
  const std::size_t end = find_end(input.bytes);
  if (end == std::string_view::npos) {
    input.fail({}, "truncated: the header has no end_header");
  }
  PlyHeader header = HeaderReader(input, input.bytes.substr(0, end)).read();
  header.bytes = end;
  return header;
}

}  // namespace hsr
