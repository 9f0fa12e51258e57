#include "scene/readers/read_mtl.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "scene/readers/text_lines.h"

namespace hsr {

namespace {

class MtlReader {
 public:
  MtlReader(const Input& input, MaterialLibrary& library)
      : input_(input), lines_(input.bytes), library_(library) {}

  void read() {
    ReadProgress progress(input_);
    while (lines_.next_line()) {
      progress.at(lines_.offset());
      const std::string_view keyword = lines_.word();
      if (keyword == "newmtl") {
        begin_material();
      } else if (keyword == "Kd") {
        read_color();
      } else if (keyword == "d") {
        read_dissolve();
      } else if (keyword == "Tr") {
        read_transparency();
      }
    }
  }

 private:
  Place place() const { return Place::line(lines_.line()); }

  void warn(const std::string& text) {
    input_.warnings.add("material values that cannot be used as they are", place(), [&] { return text; });
  }

  void begin_material() {
    const std::string name(lines_.rest());
    has_dissolve_ = false;
    const auto [entry, is_new] = library_.try_emplace(name, Material{name});
    material_ = is_new ? &entry->second : nullptr;
    if (!is_new) {
      warn("material " + in_quotes(name) + " is defined twice: the first one counts");
    }
  }

  /// The next number of the line, within [0, 1]; nothing if there is none.
  std::optional<float> unit_value() {
    TextLines after = lines_;
    const std::string_view word = after.word();
    if (word.empty()) {
      return std::nullopt;
    }
    float value = 0;
    if (!lines_.decimal(value) || std::isnan(value)) {
      lines_ = after;
      warn(in_quotes(word) + " is not a number: left out");
      return std::nullopt;
    }
    if (value < 0 || value > 1) {
      warn("value out of [0, 1]: clamped");
    }
    return std::clamp(value, 0.0F, 1.0F);
  }

  /// Three numbers, or one for grey.
  void read_color() {
    const std::optional<float> red = unit_value();
    if (!red) {
      return;
    }
    const bool is_grey = !lines_.find_word();
    const std::optional<float> green = is_grey ? red : unit_value();
    const std::optional<float> blue = is_grey ? red : unit_value();
    if (material_ != nullptr && green && blue) {
      material_->color = glm::vec3(*red, *green, *blue);
    }
  }

  void read_dissolve() {
    const std::optional<float> opacity = unit_value();
    if (material_ != nullptr && opacity) {
      material_->opacity = *opacity;
      has_dissolve_ = true;
    }
  }

  void read_transparency() {
    const std::optional<float> transparency = unit_value();
    if (material_ != nullptr && transparency && !has_dissolve_) {
      material_->opacity = 1.0F - *transparency;
    }
  }

  const Input& input_;
  TextLines lines_;
  MaterialLibrary& library_;
  Material* material_ = nullptr;
  bool has_dissolve_ = false;
};

}  // namespace

void read_mtl(const Input& input, MaterialLibrary& library) { MtlReader(input, library).read(); }

}  // namespace hsr
