// Each scene is rendered and held against the exact answer: ids, and depths where the id is right.
#include "scenes.h"

View view_of(const check::SceneData& scene) {
  View view;
  view.width = scene.width;
  view.height = scene.height;
  std::copy(scene.clip_from_world.begin(), scene.clip_from_world.end(), view.clip_from_world);
  view.eye = {scene.eye[0], scene.eye[1], scene.eye[2]};
  view.near_depth = scene.near_depth;
  view.far_depth = scene.far_depth;
  view.triangles.resize(scene.positions.size() / 9);
  for (std::size_t id = 0; id < view.triangles.size(); ++id) {
    for (std::size_t k = 0; k < 3; ++k) {
      const float* p = scene.positions.data() + 9 * id + 3 * k;
      view.triangles[id].corners[k] = {p[0], p[1], p[2]};
    }
    std::copy_n(scene.colors.data() + 4 * id, 4, view.triangles[id].color);
  }
  return view;
}

template <class Function>
Picture picture_of(const check::SceneData& scene, Function function) {
  Picture picture(scene.width, scene.height);
  function(view_of(scene), picture);
  return picture;
}

/// Ids, with -1 for background. In a tie every triangle is right, as only the exact answer sees all of them.
check::Answer ids_of(const check::SceneData& scene, const std::vector<std::uint32_t>& ids) {
  std::vector<double> numbers;
  for (std::size_t pixel = 0; pixel < ids.size(); ++pixel) {
    const bool background = ids[pixel] == 4294967295U;
    numbers.push_back(background               ? -1.0
                      : scene.tied[pixel] != 0 ? double(scene.id[pixel])
                                               : double(ids[pixel]));
  }
  return check::picture(scene.width, numbers);
}

/// Depths where the id is right.
check::Answer depths_of(const check::SceneData& scene, const Picture& picture) {
  check::Answer answer;
  double greatest = 0.0;
  for (std::size_t pixel = 0; pixel < scene.id.size(); ++pixel) {
    const bool right = picture.id[pixel] == scene.id[pixel] && scene.id[pixel] != 4294967295U;
    answer.numbers.push_back(right ? double(picture.depth[pixel]) : scene.depth[pixel]);
    const double error = right ? std::abs(picture.depth[pixel] / scene.depth[pixel] - 1.0) : 0.0;
    if (!(error > greatest)) continue;
    greatest = error;
    const std::size_t width = static_cast<std::size_t>(scene.width);
    answer.text = "depth " + check::shown(picture.depth[pixel]) + " at pixel (" +
                  std::to_string(pixel % width) + ", " + std::to_string(pixel / width) + "), where it is " +
                  check::shown(scene.depth[pixel]);
  }
  if (answer.text.empty()) answer.text = "no depth that is off";
  return answer;
}

template <class CheckOfFunction>
void write_picture(CheckOfFunction& check, const check::SceneData& scene) {
  Picture picture(scene.width, scene.height);
  constexpr std::size_t most = 2000000;  // more steps than anybody goes through
  picture.tells_steps = scene.positions.size() / 9 * scene.id.size() < most || scene.positions.size() < 90000;
  constexpr int patience = 8;
  check::limit_seconds(patience);
  check.student()(view_of(scene), picture);
  check::limit_seconds(0);
  std::FILE* stream = check.picture();
  std::fprintf(stream, "hsr-picture 1 %d %d\n", scene.width, scene.height);
  check::write_section(stream, "id", picture.id);
  check::write_section(stream, "depth", picture.depth);
  if (picture.steps_told > 0 && picture.steps_told < most)
    check::write_section(stream, "steps", std::vector<char>(picture.steps.begin(), picture.steps.end()));
  std::fprintf(stream, "end 0\n");
}

template <class CheckOfFunction>
void checks(CheckOfFunction& check) {
  const std::vector<check::SceneData> scenes = check::read_scenes(check.data_file);
  if (check.picture() != nullptr) return write_picture(check, scenes.at(0));
  check.seconds = 10;
  check.tolerance = 1e-5;  // the depths are floats
  for (const check::SceneData& scene : scenes) {
    const bool again = std::count_if(scenes.data(), &scene, [&](const check::SceneData& earlier) {
                         return earlier.name == scene.name;
                       }) > 0;
    const std::string title =
        again ? scene.name + " with the near plane at " + check::shown(scene.near_depth) : scene.name;
    const std::string size = std::to_string(scene.width) + " by " + std::to_string(scene.height) + " pixels";
    const std::string view = "scene " + scene.name + "\npicture " + std::to_string(scene.width) + " " +
                             std::to_string(scene.height) + "\nalgorithm zbuffer";
    check.view = view;
    check.run(
        "ids of " + title, title + ", " + size,
        [&](auto function) { return ids_of(scene, picture_of(scene, function).id); },
        ids_of(scene, scene.id));
    check::Answer depths;
    depths.numbers = scene.depth;
    depths.text = "all within 1e-5";
    check.run(
        "depths of " + title, title + ", " + size,
        [&](auto function) { return depths_of(scene, picture_of(scene, function)); }, depths);
  }
}
