#include <array>
#include <bit>
#include <cstring>

#include "scene/readers/readers.h"
#include "scene/readers/scene_assembler.h"
#include "scene/readers/text_lines.h"

namespace hsr {

namespace {

/// Adds a polygon whose corners no other shares: STL has no indices.
void add_loop(std::span<const glm::vec3> corners, const Place& place, SceneAssembler& assembler,
              std::vector<std::int64_t>& indices) {
  indices.clear();
  for (const glm::vec3& corner : corners) {
    indices.push_back(static_cast<std::int64_t>(assembler.vertices()));
    assembler.add_position(corner, place);
  }
  assembler.add_face(indices, no_material, place);
}

class AsciiStlReader {
 public:
  explicit AsciiStlReader(const Input& input)
      : input_(input), lines_(input.bytes), assembler_(input.warnings, 0) {}

  Scene read() {
    ReadProgress progress(input_);
    while (lines_.next_line()) {
      progress.at(lines_.offset());
      read_statement(lower_case(std::string(lines_.word())));
    }
    if (in_facet_) {
      input_.fail(facet_, "truncated: the file ends within this facet");
    }
    if (!ended_) {
      input_.warnings.add("", {}, [] { return std::string("no endsolid: the file may be cut off"); });
    }
    return assembler_.finish();
  }

 private:
  Place place() const { return Place::line(lines_.line()); }

  void read_statement(const std::string& keyword) {
    if (keyword == "vertex") {
      read_vertex();
    } else if (keyword == "facet") {
      if (in_facet_) {
        input_.fail(place(), "facet within the facet of line " + std::to_string(facet_.number));
      }
      in_facet_ = true;
      facet_ = place();
      corners_.clear();
    } else if (keyword == "endfacet") {
      if (in_facet_) {
        add_loop(corners_, facet_, assembler_, indices_);
      }
      in_facet_ = false;
    } else if (keyword == "endsolid") {
      ended_ = true;
    } else if (keyword != "solid" && keyword != "outer" && keyword != "endloop") {
      input_.warnings.add("lines that are not understood", place(),
                          [&] { return in_quotes(keyword) + " is not understood: line ignored"; });
    }
  }

  void read_vertex() {
    glm::vec3 position(std::numeric_limits<float>::quiet_NaN());
    int numbers = 0;
    while (numbers < 3 && lines_.decimal(position[numbers])) {
      ++numbers;
    }
    const std::string_view word = lines_.word();
    if (numbers < 3 && word.empty()) {
      input_.fail(place(), "vertex has " + counted(static_cast<std::uint64_t>(numbers), "number", "numbers") +
                               " of 3");
    }
    if (!in_facet_) {
      input_.fail(place(), "vertex outside of a facet");
    }
    corners_.push_back(position);
  }

  const Input& input_;
  TextLines lines_;
  SceneAssembler assembler_;
  bool in_facet_ = false;
  bool ended_ = false;
  Place facet_;
  std::vector<glm::vec3> corners_;
  std::vector<std::int64_t> indices_;  // scratch
};

std::uint32_t little_endian(const char* bytes) {
  std::uint32_t value = 0;
  for (unsigned k = 0; k < 4; ++k) {
    value |= std::uint32_t{static_cast<unsigned char>(bytes[k])} << (8 * k);
  }
  return value;
}

}  // namespace

Scene read_stl_ascii(const Input& input) { return AsciiStlReader(input).read(); }

Scene read_stl_binary(const Input& input) {
  constexpr std::size_t header = 80 + 4;      // any text, and the number of triangles
  constexpr std::size_t record = 12 * 4 + 2;  // normal, three corners, two bytes of no fixed meaning
  if (input.bytes.size() < header) {
    input.fail({}, "not an STL file: neither text that begins with 'solid' nor 84 bytes of binary header");
  }
  const std::uint64_t count = little_endian(input.bytes.data() + 80);
  const std::uint64_t there = (input.bytes.size() - header) / record;
  if (there < count) {
    input.fail({}, "truncated: the file ends after " + std::to_string(there) + " of " +
                       std::to_string(count) + " triangles");
  }
  if (input.bytes.size() > header + count * record) {
    input.warnings.add("", {}, [&] {
      return counted(input.bytes.size() - header - count * record, "byte", "bytes") +
             " after the last triangle ignored";
    });
  }
  SceneAssembler assembler(input.warnings, 0);
  ReadProgress progress(input);
  std::vector<std::int64_t> indices;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::size_t start = header + i * record;
    progress.at(start);
    std::array<glm::vec3, 3> corners{};
    for (std::size_t k = 0; k < 9; ++k) {
      const std::uint32_t bits = little_endian(input.bytes.data() + start + 12 + 4 * k);
      corners[k / 3][static_cast<int>(k % 3)] = std::bit_cast<float>(bits);
    }
    add_loop(corners, Place::byte(start), assembler, indices);
  }
  return assembler.finish();
}

}  // namespace hsr
