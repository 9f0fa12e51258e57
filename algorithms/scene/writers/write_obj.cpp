#include <array>
#include <charconv>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include "scene/atomic_file.h"
#include "scene/obj_no_material.h"
#include "scene/writers/writers.h"

namespace hsr {

namespace fs = std::filesystem;

namespace {

/// Appends the shortest decimal that reads back as the same number.
template <class Number>
void append_number(std::string& text, Number value) {
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), end);
}

/// A name that OBJ and MTL files can hold: no blanks or control characters, not empty, no comment.
std::string safe_name(const std::string& name) {
  std::string safe;
  for (const char c : name) {
    const auto code = static_cast<unsigned char>(c);
    safe += code <= ' ' || code == 127 || c == '#' || c == '\\' ? '_' : c;
  }
  return safe.empty() ? "material" : safe;
}

/// A safe name for each material, none twice.
std::vector<std::string> unique_names(const std::vector<Material>& materials) {
  std::vector<std::string> names;
  std::set<std::string> taken{std::string(obj_no_material)};
  for (const Material& material : materials) {
    const std::string base = safe_name(material.name);
    std::string name = base;
    for (std::size_t number = names.size() + 1; !taken.insert(name).second; ++number) {
      name = base + "_" + std::to_string(number);
    }
    names.push_back(name);
  }
  return names;
}

std::string mtl_text(const std::vector<Material>& materials, const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    text += "newmtl " + names[i] + "\nKd";
    for (int k = 0; k < 3; ++k) {
      text += ' ';
      append_number(text, materials[i].color[k]);
    }
    text += "\nd ";
    append_number(text, materials[i].opacity);
    text += "\n";
  }
  return text;
}

void write_positions(const Scene& scene, OutputFile& output, RowProgress& rows) {
  std::string line;
  for (const glm::vec3& position : scene.positions) {
    rows.next();
    line = "v";
    for (int k = 0; k < 3; ++k) {
      line += ' ';
      append_number(line, position[k]);
    }
    output.write(line += '\n');
  }
}

/// Faces of triangles in id order, with usemtl where the material changes.
void write_triangles(const Scene& scene, const std::vector<std::string>& names, OutputFile& output,
                     RowProgress& rows) {
  std::uint32_t material = no_material;
  std::string line;
  for (const Triangle& triangle : scene.triangles) {
    rows.next();
    line.clear();
    if (triangle.material != material) {
      material = triangle.material;
      line = "usemtl " + (material == no_material ? std::string(obj_no_material) : names[material]) + "\n";
    }
    line += 'f';
    for (const std::uint32_t corner : triangle.corners) {
      line += ' ';
      append_number(line, corner + 1);
    }
    output.write(line += '\n');
  }
}

}  // namespace

void write_obj(const Scene& scene, const fs::path& file, const Progress& progress) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  const bool has_library = !scene.materials.empty() && (!fs::exists(status) || fs::is_regular_file(status));
  const std::vector<std::string> names = unique_names(scene.materials);
  const fs::path library = file.parent_path() / (safe_name(file.stem().string()) + ".mtl");
  write_file_atomically(file, [&](const fs::path& temporary) {
    OutputFile output(temporary);
    if (has_library) {
      output.write("mtllib " + library.filename().string() + "\n");
    }
    RowProgress rows(scene, progress);
    write_positions(scene, output, rows);
    write_triangles(scene, names, output, rows);
    output.close();
    if (has_library) {  // here, so that a failure leaves neither file behind
      write_file_atomically(library, [&](const fs::path& temporary_library) {
        write_bytes(temporary_library, mtl_text(scene.materials, names));
      });
    }
  });
}

}  // namespace hsr
