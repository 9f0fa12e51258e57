#include "exercise/scene_data.h"

#include <cstdlib>
#include <span>
#include <sstream>

#include "exact/exact_answer.h"
#include "picture.h"
#include "scene/atomic_file.h"
#include "scene/errors.h"
#include "values.h"
#include "view/shading.h"

namespace hsr {
namespace {

template <class Number>
void append(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

template <class Number>
void append_all(std::string& bytes, std::span<const Number> numbers) {
  bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes());
}

void append_view(std::string& bytes, const std::string& name, const View& view) {
  append(bytes, static_cast<std::uint32_t>(name.size()));
  bytes += name;
  append(bytes, std::int32_t{view.width});
  append(bytes, std::int32_t{view.height});
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) append(bytes, view.clip_from_world[column][row]);
  }
  for (int k = 0; k < 3; ++k) append(bytes, view.camera.eye[k]);
  append(bytes, view.near_depth);
  append(bytes, view.far_depth);
  const Scene& scene = *view.scene;
  append(bytes, static_cast<std::uint32_t>(scene.triangles.size()));
  for (const Triangle& triangle : scene.triangles) {
    for (const std::uint32_t corner : triangle.corners) append(bytes, scene.positions[corner]);
  }
  for (const glm::vec4& color : surface_colors(scene, 1)) append(bytes, color);
}

/// Ids, depths, and where the nearest two are equally deep.
void append_answer(std::string& bytes, const View& view) {
  const exact::ExactAnswer exact(view, 1);
  const exact::DepthLists lists = exact.depth_lists(0, view.height);
  std::vector<std::uint32_t> ids;
  std::vector<double> depths;
  std::vector<std::uint8_t> tied;
  for (std::size_t pixel = 0; pixel + 1 < lists.begin.size(); ++pixel) {
    const std::span<const exact::Fragment> list(lists.fragments.data() + lists.begin[pixel],
                                                lists.begin[pixel + 1] - lists.begin[pixel]);
    ids.push_back(list.empty() ? background_id : list[0].id);
    depths.push_back(list.empty() ? std::numeric_limits<double>::infinity() : list[0].depth);
    tied.push_back(list.size() > 1 && list[1].tied ? 1 : 0);
  }
  append(bytes, static_cast<std::uint32_t>(ids.size()));
  append_all<std::uint32_t>(bytes, ids);
  append_all<double>(bytes, depths);
  append_all<std::uint8_t>(bytes, tied);
}

void write_data(const std::filesystem::path& file, const std::string& bytes) {
  write_file_atomically(file, [&](const std::filesystem::path& temporary) { write_bytes(temporary, bytes); });
}

std::string from_environment(const char* name) {
  const char* value = std::getenv(name);
  if (value == nullptr)
    throw UsageError(std::string("picture: the variable ") + name + " is not set; hsr view --from sets it");
  return value;
}

}  // namespace

std::filesystem::path write_scene_data(const Exercise& exercise, const std::filesystem::path& folder) {
  if (exercise.scenes.empty()) return {};
  std::string views;
  std::uint32_t count = 0;
  std::istringstream lines(exercise.scenes);
  for (std::string line; std::getline(lines, line); ++count) {
    std::istringstream words(line);
    std::string name;
    std::string size;
    words >> name >> size;
    ReadReport report;
    const Scene scene = open_scene(name, report, {});
    PictureOptions options;
    options.size = parse_size("scenes.txt", size);
    if (double near_depth = 0.0; words >> near_depth) options.near_depth = near_depth;
    const View view = choose_view(scene, options);
    append_view(views, name, view);
    append_answer(views, view);
  }
  std::string bytes;
  append(bytes, count);
  std::filesystem::path file = std::filesystem::absolute(folder) / "scenes.bin";
  write_data(file, bytes + views);
  return file;
}

void write_view_data(const View& view, const std::filesystem::path& file) {
  std::string bytes;
  append(bytes, std::uint32_t{1});
  append_view(bytes, view.scene->name, view);
  append(bytes, std::uint32_t{0});
  write_data(file, bytes);
}

View view_from_environment(const Scene& scene) {
  PictureOptions options;
  const auto point = [](const char* name) { return parse_point(name, from_environment(name)); };
  const auto number = [](const char* name) { return parse_number(name, from_environment(name)); };
  options.size = parse_size("HSR_SIZE", from_environment("HSR_SIZE"));
  options.camera.eye = point("HSR_EYE");
  options.camera.target = point("HSR_TARGET");
  options.camera.up = point("HSR_UP");
  options.camera.vertical_fov_degrees = number("HSR_FOV");
  options.near_depth = number("HSR_NEAR");
  options.far_depth = number("HSR_FAR");
  return choose_view(scene, options);
}

}  // namespace hsr
