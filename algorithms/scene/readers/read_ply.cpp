#include <algorithm>
#include <array>

#include "scene/readers/ply_body.h"
#include "scene/readers/ply_header.h"
#include "scene/readers/readers.h"
#include "scene/readers/scene_assembler.h"

namespace hsr {

namespace {

bool is_corner_list(const PlyProperty& property) {
  return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// Reads the elements of a body that is walked through by `Body` (see ply_body.h).
template <class Body>
class PlyReader {
 public:
  PlyReader(const Input& input, const PlyHeader& header)
      : input_(input),
        header_(header),
        body_(input, header),
        assembler_(input.warnings, 0),
        progress_(input) {}

  Scene read() {
    for (const PlyElement& element : header_.elements) {
      check(element);
      read_rows(element);
    }
    if (body_.has_rest()) {
      input_.warnings.add("", {}, [] { return std::string("what follows the last row is ignored"); });
    }
    return assembler_.finish();
  }

 private:
  static std::string rows_of(const PlyElement& element) {
    return std::to_string(element.rows) + " rows of element " + in_quotes(element.name);
  }

  void read_rows(const PlyElement& element) {
    const std::uint64_t rows = element.properties.empty() ? 0 : element.rows;
    std::uint64_t row = 0;
    try {
      for (; row < rows; ++row) {
        progress_.at(body_.offset());
        body_.begin_row();
        read_row(element);
        body_.end_row();
      }
    } catch (const PlyTruncated&) {
      input_.fail(body_.place(),
                  "truncated: the file ends after " + std::to_string(row) + " of " + rows_of(element));
    }
  }

  /// Refuses an element that cannot be there before anything is made for it.
  void check(const PlyElement& element) const {
    const auto has = [&](std::string_view name) {
      return std::any_of(element.properties.begin(), element.properties.end(),
                         [&](const PlyProperty& each) { return each.name == name && !each.is_list; });
    };
    if (element.name == "vertex" && !(has("x") && has("y") && has("z"))) {
      input_.fail(element.place, "element vertex needs the properties x, y and z");
    }
    if (is_surface(element)) {
      const auto list = std::find_if(element.properties.begin(), element.properties.end(), is_corner_list);
      if (list == element.properties.end()) {
        input_.fail(element.place,
                    "element " + in_quotes(element.name) + " needs a list vertex_indices or vertex_index");
      }
      if (list->type == PlyType::float32 || list->type == PlyType::float64) {
        input_.fail(element.place, "vertex indices must be of a whole type");
      }
    }
    if (!element.properties.empty() && !body_.can_hold(element)) {
      input_.fail(element.place, "truncated: " + rows_of(element) + " promised, but only " +
                                     counted(body_.bytes_left(), "byte", "bytes") + " left");
    }
  }

  static bool is_surface(const PlyElement& element) {
    return element.name == "face" || element.name == "tristrips";
  }

  void read_row(const PlyElement& element) {
    const bool is_vertex = element.name == "vertex";
    const bool is_surface_row = is_surface(element);
    glm::vec3 position(0.0F);
    corners_.clear();
    for (const PlyProperty& property : element.properties) {
      if (property.is_list) {
        read_list(property, is_surface_row && is_corner_list(property));
      } else if (is_vertex && property.name.size() == 1 && property.name[0] >= 'x' &&
                 property.name[0] <= 'z') {
        position[property.name[0] - 'x'] = body_.coordinate(property.type);
      } else {
        body_.skip(property.type, 1);
      }
    }
    if (is_vertex) {
      assembler_.add_position(position, body_.place());
    } else if (element.name == "face") {
      assembler_.add_face(corners_, no_material, body_.place());
    } else if (element.name == "tristrips") {
      add_strips();
    }
  }

  void read_list(const PlyProperty& property, bool keep) {
    const std::int64_t length = body_.whole(property.count_type);
    if (length < 0) {
      input_.fail(body_.place(), "list " + in_quotes(property.name) + " has a negative length");
    }
    if (!body_.has_room(property.type, static_cast<std::uint64_t>(length))) {
      throw PlyTruncated();
    }
    if (!keep) {
      body_.skip(property.type, static_cast<std::uint64_t>(length));
      return;
    }
    corners_.clear();
    for (std::int64_t i = 0; i < length; ++i) {
      corners_.push_back(body_.whole(property.type));
    }
  }

  /// Makes the triangles of strips, which an index below 0 ends. Every other one is turned round.
  void add_strips() {
    std::size_t start = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (corners_[i] < 0) {
        start = i + 1;
      } else if (i >= start + 2) {
        std::array<std::int64_t, 3> corners{corners_[i - 2], corners_[i - 1], corners_[i]};
        if ((i - start) % 2 != 0) {
          std::swap(corners[0], corners[1]);
        }
        assembler_.add_face(corners, no_material, body_.place());
      }
    }
  }

  const Input& input_;
  const PlyHeader& header_;
  Body body_;
  SceneAssembler assembler_;
  ReadProgress progress_;
  std::vector<std::int64_t> corners_;  // scratch
};

}  // namespace

Scene read_ply(const Input& input) {
  const PlyHeader header = read_ply_header(input);
  switch (header.format) {
    case PlyHeader::Format::ascii:
      return PlyReader<PlyAsciiBody>(input, header).read();
    case PlyHeader::Format::binary_little_endian:
      return PlyReader<PlyBinaryBody<std::endian::little>>(input, header).read();
    case PlyHeader::Format::binary_big_endian:
      break;
  }
  return PlyReader<PlyBinaryBody<std::endian::big>>(input, header).read();
}

}  // namespace hsr
