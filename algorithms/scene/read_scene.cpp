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

// A mesh that is closed but for a few edges has a rim, or a slip in it. Triangles that share no
// corners at all are nothing to warn of, and in a large mesh the search would take longer than
// reading does.
void warn_of_gaps(const Scene& scene, Warnings& warnings) {
  constexpr std::size_t most_triangles = 100000;
  constexpr std::size_t least_edges_for_each_open_one = 10;
  if (scene.triangles.size() > most_triangles) return;
  const EdgeCounts counts = count_edges(scene);
  if (counts.open == 0 || counts.open * least_edges_for_each_open_one > counts.edges) return;
  warnings.add("gaps", {}, [&] {
    return counted(counts.open, "edge", "edges") + " of " + std::to_string(counts.edges) +
           " belong to one triangle only: the surface has a rim or gaps";
  });
}

}  // namespace

Scene read_scene(const fs::path& file, ReadReport& report, const Progress& progress) {
  try {
    const std::string bytes = file_bytes(file, progress);
    Warnings warnings(file.string());
    Scene scene = read(Input{file, bytes, progress, warnings});
    scene.name = file.filename().string();
    warn_of_gaps(scene, warnings);
    report.warnings = warnings.lines();
    report.bytes = bytes.size();
    (void)report_progress(progress, "reading", 1.0);
    return scene;
  } catch (const std::bad_alloc&) {
    throw InputError(place_message(file.string(), {}, "not enough memory to read it"));
  }
}

}  // namespace hsr
