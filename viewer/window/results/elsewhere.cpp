#include "window/results/elsewhere.h"

#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "scene/errors.h"
#include "view/shading.h"

namespace hsr::window {
namespace {

std::string text_of(double number) {
  std::array<char, 40> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

std::string text_of(const glm::dvec3& point) {
  return text_of(point.x) + "," + text_of(point.y) + "," + text_of(point.z);
}

/// What the command finds in its environment.
std::vector<std::pair<std::string, std::string>> variables_of(const ModelKey& scene, const View& view) {
  std::string matrix;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column)
      matrix += (matrix.empty() ? "" : " ") + text_of(view.clip_from_world[column][row]);
  }
  std::error_code unknown;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", unknown);
  return {{"HSR", unknown ? "hsr" : self.string()},
          {"HSR_SCENE", scene.scene},
          {"HSR_SIZE", std::to_string(view.width) + "x" + std::to_string(view.height)},
          {"HSR_EYE", text_of(view.camera.eye)},
          {"HSR_TARGET", text_of(view.camera.target)},
          {"HSR_UP", text_of(view.camera.up)},
          {"HSR_FOV", text_of(view.camera.vertical_fov_degrees)},
          {"HSR_NEAR", text_of(view.near_depth)},
          {"HSR_FAR", text_of(view.far_depth)},
          {"HSR_CLIP_FROM_WORLD", matrix}};
}

PictureLimits limits_for(const Model& model) {
  return {.triangles = static_cast<std::uint32_t>(model.scene->triangles.size())};
}

/// Colours of the triangles that are shown, where none were told.
void fill_colors(Frame& frame, const Scene& scene) {
  if (!frame.color.empty()) return;
  frame.color.assign(frame.pixel_count(), glm::vec4(0.0F));
  for (std::size_t pixel = 0; pixel < frame.pixel_count(); ++pixel) {
    if (frame.id[pixel] != background_id) frame.color[pixel] = opaque(surface_color(scene, frame.id[pixel]));
  }
}

/// A stream over bytes that somebody else keeps.
class BytesBuffer : public std::streambuf {
 public:
  explicit BytesBuffer(std::string& bytes) { setg(bytes.data(), bytes.data(), bytes.data() + bytes.size()); }
};

/// Plays back what was told.
class ToldRenderer : public Renderer {
 public:
  explicit ToldRenderer(std::shared_ptr<const FromElsewhere> told) : told_(std::move(told)) {}

  RenderReport render(const View& /*view*/, const RenderOptions& options, Frame& frame) override {
    const Frame& whole = told_->picture.frame;
    const PixelBox box = options.window.value_or(PixelBox{0, whole.width - 1, 0, whole.height - 1});
    for (int j = box.first_j; j <= box.last_j; ++j) {
      for (int i = box.first_i; i <= box.last_i; ++i) {
        const std::size_t pixel = whole.index(i, j);
        frame.id[pixel] = whole.id[pixel];
        frame.depth[pixel] = whole.depth[pixel];
        frame.color[pixel] = whole.color[pixel];
      }
    }
    return {};
  }

  RenderReport trace(const View& view, const RenderOptions& options, const EventListener& listener,
                     Frame& frame) override {
    for (const Event& event : told_->picture.steps) {
      const PixelBox* box = options.window ? &*options.window : nullptr;
      const bool inside = box == nullptr || event.i < 0 ||
                          (box->first_i <= event.i && event.i <= box->last_i && box->first_j <= event.j &&
                           event.j <= box->last_j);
      if (inside) listener(event);
    }
    return render(view, options, frame);
  }

 private:
  std::shared_ptr<const FromElsewhere> told_;
};

std::unique_ptr<Renderer> prepare_nothing(const Scene& /*scene*/, const Settings& /*settings*/,
                                          const RenderOptions& /*options*/) {
  throw InputError("a program of another process is run, not prepared");
}

constexpr Algorithm program = {
    .name = "program",
    .title = "Another program",
    .idea = "A picture that another process made, looked at with the same tools.",
    .source = "",
    .variant_of = "",
    .traits = {.time = "its own",
               .memory = "its own",
               .transparency = "its own",
               .cycles = "its own",
               .exact = false},
    .settings = {},
    .skips = {},
    .prepare = prepare_nothing,
};

}  // namespace

FromElsewhere read_elsewhere(const ElsewhereKey& key, const Model& model) {
  const std::string& name = key.source.words;
  std::ifstream stream(name, std::ios::binary);
  std::error_code ignored;
  if (!stream || std::filesystem::is_directory(name, ignored)) throw InputError(name + ": cannot be read");
  FromElsewhere told;
  told.picture = read_picture_stream(stream, name, limits_for(model));
  fill_colors(told.picture.frame, *model.scene);
  return told;
}

FromElsewhere run_elsewhere(const ElsewhereKey& key, const Model& model, const View& view,
                            const ChildLimits& limits, const Progress& progress) {
  if (!model.key.moved.empty()) throw InputError("the program knows nothing of the corners that were moved");
  ChildRun run = run_command(key.source.words, variables_of(model.key, view), limits, progress);
  if (!report_progress(progress, "reading the picture", 1.0)) throw InputError("stopped");
  const std::string last = run.err.empty() ? "" : "\n" + run.err;
  if (!run.ended.empty()) throw InputError("the program gave no picture: " + run.ended + last);
  FromElsewhere told;
  told.said = run.err;
  told.seconds = run.seconds;
  try {
    BytesBuffer buffer(run.out);
    std::istream stream(&buffer);
    told.picture = read_picture_stream(stream, "what the program wrote", limits_for(model));
  } catch (const InputError& error) {
    throw InputError(error.what() + last);
  }
  const Frame& frame = told.picture.frame;
  if (frame.width != view.width || frame.height != view.height) {
    throw InputError("the program made a picture of " + std::to_string(frame.width) + "x" +
                     std::to_string(frame.height) + " pixels in place of " + std::to_string(view.width) +
                     "x" + std::to_string(view.height) + last);
  }
  fill_colors(told.picture.frame, *model.scene);
  return told;
}

const AlgorithmSpec& program_spec() {
  static const AlgorithmSpec spec = {&program, {}};
  return spec;
}

std::unique_ptr<Renderer> told_renderer(std::shared_ptr<const FromElsewhere> told) {
  return std::make_unique<ToldRenderer>(std::move(told));
}

}  // namespace hsr::window
