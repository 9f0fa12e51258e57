#include "scene/read_scene.h"

#include <algorithm>
#include <new>

#include "scene/open_edges.h"
#include "scene/readers/file_bytes.h"
#include "scene/readers/format.h"
#include "scene/readers/readers.h"

namespace hsr {

namespace fs = std::filesystem;

namespace {

void refuse_what_is_not_text(const Input& input) {
  if (input.bytes.starts_with("\xFE\xFF") || input.bytes.starts_with("\xFF\xFE")) {
    input.fail({}, "the text is UTF-16: save it as UTF-8");
  }
  const std::size_t nul = input.bytes.find('\0');
  if (nul != std::string_view::npos) {
    const auto lines =
        std::count(input.bytes.begin(), input.bytes.begin() + static_cast<std::ptrdiff_t>(nul), '\n');
    input.fail(Place::line(static_cast<std::uint64_t>(lines) + 1),
               "not a text file: byte " + std::to_string(nul) + " is NUL");
  }
}

Scene read(const Input& input) {
  if (input.bytes.empty()) {
    input.fail({}, "empty file");
  }
  const Format format = format_of(input.file, input.bytes);
  if (is_text(format)) {
    refuse_what_is_not_text(input);
  }
  switch (format) {
    case Format::obj:
      return read_obj(input);
    case Format::ply:
      return read_ply(input);
    case Format::off:
      return read_off(input);
    case Format::stl_ascii:
      return read_stl_ascii(input);
    case Format::stl_binary:
      return read_stl_binary(input);
    case Format::gltf:
      return read_gltf(input);
    case Format::glb:
      return read_glb(input);
    case Format::unknown:
      break;
  }
  input.fail({}, "not a scene: neither content nor ending is that of OBJ, PLY, OFF, STL, glTF or GLB");
}

// A rim is often meant; a hole with three edges hardly ever is.
void warn_of_holes(const Scene& scene, Warnings& warnings) {
  const std::size_t holes = open_edges(scene).triangular_holes;
  if (holes == 0) return;
  warnings.add("holes", {}, [&] {
    return counted(holes, "hole", "holes") +
           " with three edges: a triangle is missing, or a face leaves out a corner that its neighbours have";
  });
}

}  // namespace

Scene read_scene(const fs::path& file, ReadReport& report, const Progress& progress) {
  try {
    const std::string bytes = file_bytes(file, progress);
    Warnings warnings(file.string());
    Scene scene = read(Input{file, bytes, progress, warnings});
    scene.name = file.filename().string();
    warn_of_holes(scene, warnings);
    report.warnings = warnings.lines();
    report.bytes = bytes.size();
    (void)report_progress(progress, "reading", 1.0);
    return scene;
  } catch (const std::bad_alloc&) {
    throw InputError(place_message(file.string(), {}, "not enough memory to read it"));
  }
}

}  // namespace hsr
