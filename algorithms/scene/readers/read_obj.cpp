#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scene/readers/numbers.h"
#include "scene/readers/obj_materials.h"
#include "scene/readers/readers.h"
#include "scene/readers/scene_assembler.h"
#include "scene/readers/text_lines.h"

namespace hsr {

namespace {

/// Statements that say nothing about triangles: names, smoothing, lines, points, free-form curves.
constexpr std::array<std::string_view, 36> passed_over{
    "g",     "o",     "s",          "l",         "p",        "vp",       "cstype", "deg",    "bmat",
    "step",  "curv",  "curv2",      "surf",      "parm",     "trim",     "hole",   "scrv",   "sp",
    "end",   "con",   "mg",         "bevel",     "lod",      "call",     "csh",    "maplib", "usemap",
    "ctech", "stech", "shadow_obj", "trace_obj", "c_interp", "d_interp", "bzp",    "cdc",    "res"};

/// What a word such as "7/2/-1" of a face says: numbers as they stand; 0 where there is none.
struct Corner {
  std::int64_t position = 0;
  std::int64_t texture = 0;
  std::int64_t normal = 0;
  bool has_texture = false;
  bool has_normal = false;
};

/// Reads v, v/vt, v//vn or v/vt/vn, also with nothing after a slash. Returns where that ends, or null.
const char* parse_corner(const char* at, const char* end, Corner& corner) {
  at = parse_whole(at, end, corner.position);
  if (at == nullptr || at == end || *at != '/') {
    return at;
  }
  if (const char* texture_end = parse_whole(++at, end, corner.texture)) {
    corner.has_texture = true;
    at = texture_end;
  }
  if (at == end || *at != '/') {
    return at;
  }
  const char* normal_end = parse_whole(++at, end, corner.normal);
  corner.has_normal = normal_end != nullptr;
  return corner.has_normal ? normal_end : at;
}

class ObjReader {
 public:
  explicit ObjReader(const Input& input)
      : input_(input),
        lines_(input.bytes, TextLines::Backslash::continues_line),
        assembler_(input.warnings, 1),
        materials_(input) {}

  Scene read() {
    ReadProgress progress(input_);
    while (lines_.next_line()) {
      progress.at(lines_.offset());
      read_statement(lines_.word());
    }
    if (understood_ == 0 && misunderstood_ > 0) {
      input_.fail({}, "not an OBJ file: none of its lines is understood");
    }
    Scene scene = assembler_.finish();
    materials_.assign(scene);
    return scene;
  }

 private:
  Place place() const { return Place::line(lines_.line()); }

  void read_statement(std::string_view keyword) {
    ++understood_;
    if (keyword == "v") {
      read_vertex();
    } else if (keyword == "f" || keyword == "fo") {
      read_face();
    } else if (keyword == "vt") {
      ++textures_;
    } else if (keyword == "vn") {
      ++normals_;
    } else if (keyword == "usemtl") {
      material_ = materials_.use(lines_.rest(), place());
    } else if (keyword == "mtllib") {
      materials_.add_libraries(lines_.rest(), place());
    } else if (std::find(passed_over.begin(), passed_over.end(), keyword) == passed_over.end()) {
      --understood_;
      ++misunderstood_;
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
    if (numbers == 3) {
      check_vertex_attributes();
      assembler_.add_position(position, place());
      return;
    }
    const std::string_view word = lines_.word();
    if (!word.empty()) {
      assembler_.add_position(position, place(), in_quotes(word) + " is not a number");
    } else if (numbers == 2) {
      position.z = 0.0F;
      input_.warnings.add("vertices with x and y only", place(),
                          [] { return std::string("vertex has only x and y: z is taken as 0"); });
      assembler_.add_position(position, place());
    } else {
      position = glm::vec3(std::numeric_limits<float>::quiet_NaN());
      assembler_.add_position(position, place(), "has " + counted(numbers, "number", "numbers") + " of 3");
    }
  }

  /// What follows the position (a weight, a colour) is not used, but said if it is no number.
  void check_vertex_attributes() {
    while (lines_.find_word()) {
      float value = 0;
      if (!lines_.decimal(value) || !std::isfinite(value)) {
        input_.warnings.add("vertices with bad numbers after the position", place(),
                            [] { return std::string("bad number after the vertex position: ignored"); });
        return;
      }
    }
  }

  void read_face() {
    corners_.clear();
    attribute_warned_ = false;
    while (lines_.find_word()) {
      Corner corner;
      if (!lines_.parsed_word(
              [&](const char* at, const char* end) { return parse_corner(at, end, corner); })) {
        input_.warnings.add("faces that cannot be read", place(),
                            [&] { return in_quotes(lines_.word()) + " is not a corner: face dropped"; });
        return;
      }
      const auto known = static_cast<std::int64_t>(assembler_.vertices());
      if (corner.position == 0 || corner.position < -known) {
        assembler_.drop_for_index(bad_index(corner.position), place());
        return;
      }
      corners_.push_back(corner.position > 0 ? corner.position - 1 : known + corner.position);
      check_attribute("texture", corner.has_texture, corner.texture, textures_);
      check_attribute("normal", corner.has_normal, corner.normal, normals_);
    }
    assembler_.add_face(corners_, material_, place());
  }

  std::string bad_index(std::int64_t index) const {
    return "vertex index " + std::to_string(index) + " out of range (" +
           (index == 0 ? "OBJ counts from 1"
                       : counted(assembler_.vertices(), "vertex", "vertices") + " so far") +
           ")";
  }

  /// Texture and normal indices are not used, but said if they are wrong.
  void check_attribute(std::string_view what, bool given, std::int64_t index, std::int64_t count) {
    if (given && !attribute_warned_ && (index == 0 || index > count || index < -count)) {
      attribute_warned_ = true;
      input_.warnings.add("faces with a texture or normal index out of range", place(), [&] {
        return std::string(what) + " index " + std::to_string(index) + " out of range (" +
               std::to_string(count) + " so far): ignored";
      });
    }
  }

  const Input& input_;
  TextLines lines_;
  SceneAssembler assembler_;
  ObjMaterials materials_;
  std::uint32_t material_ = no_material;
  std::int64_t textures_ = 0;
  std::int64_t normals_ = 0;
  std::uint64_t understood_ = 0;
  std::uint64_t misunderstood_ = 0;
  bool attribute_warned_ = false;      // in the face at hand
  std::vector<std::int64_t> corners_;  // scratch
};

}  // namespace

Scene read_obj(const Input& input) { return ObjReader(input).read(); }

}  // namespace hsr
