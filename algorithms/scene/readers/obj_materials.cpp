#include "scene/readers/obj_materials.h"

#include <algorithm>
#include <system_error>

#include "scene/obj_no_material.h"
#include "scene/readers/file_bytes.h"
#include "scene/readers/text_lines.h"

namespace hsr {

namespace fs = std::filesystem;

std::uint32_t ObjMaterials::use(std::string_view name, const Place& place) {
  const auto known = slot_of_name_.find(name);
  if (known != slot_of_name_.end()) {
    return known->second;
  }
  const auto slot = static_cast<std::uint32_t>(slots_.size());
  slots_.push_back({std::string(name), place});
  slot_of_name_.emplace(name, slot);
  return slot;
}

/// Looks for a library beside the OBJ file, also with Windows' separators, compressed, or with other
/// capitals (which Windows does not tell apart). Only a regular file will do: a device might not end.
bool ObjMaterials::find_file(std::string_view name, fs::path& found) const {
  std::string portable(name);
  std::replace(portable.begin(), portable.end(), '\\', '/');
  for (const std::string& candidate : {std::string(name), portable, portable + ".gz"}) {
    std::error_code error;
    found = input_.file.parent_path() / candidate;
    if (fs::is_regular_file(found, error)) {
      return true;
    }
  }
  const fs::path wanted = input_.file.parent_path() / portable;
  const std::string lower = lower_case(wanted.filename().string());
  std::error_code error;
  const fs::path folder = wanted.has_parent_path() ? wanted.parent_path() : fs::path(".");
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    found = entry->path();
    if (lower_case(found.filename().string()) == lower && fs::is_regular_file(found, error)) {
      return true;
    }
  }
  return false;
}

void ObjMaterials::add_library(const fs::path& file) {
  if (!libraries_.insert(file).second) {
    return;
  }
  const std::string bytes = file_bytes(file, input_.progress);
  Warnings warnings(file.string());
  read_mtl(Input{file, bytes, input_.progress, warnings}, library_);
  input_.warnings.append(warnings);
}

void ObjMaterials::add_libraries(std::string_view names, const Place& place) {
  std::vector<std::string_view> wanted{names};
  fs::path file;
  if (!find_file(names, file)) {
    wanted.clear();
    TextLines words(names);
    while (words.next_line()) {
      for (std::string_view name = words.word(); !name.empty(); name = words.word()) {
        wanted.push_back(name);
      }
    }
  }
  for (const std::string_view name : wanted) {
    std::string reason = "no such file";
    try {
      if (find_file(name, file)) {
        add_library(file);
        continue;
      }
    } catch (const InputError& error) {
      reason = error.what();
    }
    input_.warnings.add("material libraries that cannot be read", place,
                        [&] { return "material library " + in_quotes(name) + " cannot be read: " + reason; });
  }
}

void ObjMaterials::assign(Scene& scene) const {
  std::vector<std::uint32_t> material_of_slot(slots_.size(), no_material);
  std::vector<bool> seen(slots_.size(), false);
  std::vector<const Slot*> undefined;
  for (Triangle& triangle : scene.triangles) {
    const std::uint32_t slot = triangle.material;
    if (slot == no_material) {
      continue;
    }
    if (!seen[slot]) {
      seen[slot] = true;
      const auto definition = library_.find(slots_[slot].name);
      if (definition != library_.end()) {
        material_of_slot[slot] = static_cast<std::uint32_t>(scene.materials.size());
        scene.materials.push_back(definition->second);
      } else if (slots_[slot].name != obj_no_material) {
        undefined.push_back(&slots_[slot]);
      }
    }
    triangle.material = material_of_slot[slot];
  }
  warn_of_undefined(undefined);
}

void ObjMaterials::warn_of_undefined(const std::vector<const Slot*>& undefined) const {
  if (undefined.empty()) {
    return;
  }
  constexpr std::size_t named = 3;
  std::string names;
  for (std::size_t i = 0; i < std::min(undefined.size(), named); ++i) {
    names += (i > 0 ? ", " : " ") + in_quotes(undefined[i]->name);
  }
  if (undefined.size() > named) {
    names += " and " + std::to_string(undefined.size() - named) + " more";
  }
  input_.warnings.add("", undefined.front()->place, [&] {
    return (undefined.size() == 1 ? "material" + names + " is" : "materials" + names + " are") +
           " not defined: colours are chosen by face";
  });
}

}  // namespace hsr
