#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/readers/input.h"
#include "scene/readers/read_mtl.h"
#include "scene/scene.h"

namespace hsr {

/// The materials of an OBJ file while it is read: faces refer to slots, one for each name that
/// usemtl gives, and slots are matched with definitions at the end, wherever these stand.
class ObjMaterials {
 public:
  explicit ObjMaterials(const Input& input) : input_(input) {}

  /// usemtl: the slot for faces from here on.
  std::uint32_t use(std::string_view name, const Place& place);

  /// mtllib: reads the files that `names` names, one name with blanks or several between blanks.
  /// What cannot be read is warned of.
  void add_libraries(std::string_view names, const Place& place);

  /// Replaces slots in the triangles by materials: those that are used and defined, in the order of
  /// first use. A name that is used and not defined is warned of and becomes no material.
  void assign(Scene& scene) const;

 private:
  struct Slot {
    std::string name;
    Place place;
  };
  bool find_file(std::string_view name, std::filesystem::path& found) const;
  void warn_of_undefined(const std::vector<const Slot*>& undefined) const;
  void add_library(const std::filesystem::path& file);

  const Input& input_;
  std::vector<Slot> slots_;
  std::map<std::string, std::uint32_t, std::less<>> slot_of_name_;
  std::set<std::filesystem::path> libraries_;  // read already
  MaterialLibrary library_;
};

}  // namespace hsr
