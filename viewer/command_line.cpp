// The only source that includes CLI11, which takes seconds to compile.

#include "command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "help_formatter.h"
#include "nearest_name.h"
#include "option_helpers.h"
#include "scene/errors.h"
#include "skip_choice.h"

namespace hsr {
namespace {

constexpr int greatest_threads = 1024;
constexpr int greatest_repeats = 1000000;

int all_cores() {
  const auto cores = static_cast<int>(std::thread::hardware_concurrency());
  return std::clamp(cores, 1, greatest_threads);
}

constexpr const char* scene_help =
    "A file (OBJ with MTL, PLY, OFF, STL, glTF, GLB; also .gz) or a built-in scene such as box or soup:5000 "
    "(hsr list scenes). A built-in scene goes before a file of the same name: write ./box for the file.";

void add_scene(CLI::App& app, std::string& scene) {
  app.add_option("SCENE", scene, scene_help)->required()->type_name("");
}

void add_camera(CLI::App& app, CameraOptions& camera) {
  const auto point = [&app](const char* name, std::optional<glm::dvec3>& value, const char* help) {
    add_value(
        app, name, "X,Y,Z",
        [&value](const auto& option, const auto& text) { value = parse_point(option, text); }, help);
  };
  point("--eye", camera.eye,
        "Where the camera stands. What is not given of eye, target, up and fov comes from the scene's own "
        "camera, or from one that frames the whole scene.");
  point("--target", camera.target, "What the camera looks at.");
  point("--up", camera.up, "Which way is up in the picture.");
  add_value(
      app, "--fov", "DEGREES",
      [&camera](const auto& option, const auto& text) {
        camera.vertical_fov_degrees = parse_number(option, text);
      },
      "Vertical field of view.");
}

void add_picture(CLI::App& app, PictureOptions& picture) {
  add_scene(app, picture.scene);
  add_value(
      app, "-s,--size", "WxH",
      [&picture](const auto& option, const auto& text) { picture.size = parse_size(option, text); },
      "Width and height in pixels (default 1280x720).");
  add_camera(app, picture.camera);
  const auto depth = [&](const char* name, std::optional<double>& value, const char* help) {
    add_value(
        app, name, "DEPTH",
        [&value](const auto& option, const auto& text) { value = parse_number(option, text); }, help);
  };
  depth("--near", picture.near_depth,
        "Nearest eye depth that is seen, in scene units (default: just before the scene's bounding sphere).");
  depth("--far", picture.far_depth, "Farthest eye depth that is seen (default: just behind that sphere).");
  picture.threads = all_cores();
  add_value(
      app, "--threads", "N",
      [&picture](const auto& option, const auto& text) {
        picture.threads = parse_whole_number(option, text, 1, greatest_threads);
      },
      "How many threads work (default: one per core).");
  app.add_option("--no-skip", picture.skips_off,
                 "Do work that would be left out because it cannot change the picture: the name of a skip, "
                 "several with commas, or all (hsr list algorithms).")
      ->type_name("NAME")
      ->delimiter(',')
      ->allow_extra_args(false);
}

void add_view(CLI::App& program, ViewCommand& command) {
  CLI::App& app = *program.add_subcommand(
      "view", "Open the viewer: toggle algorithms, look into pixels, step both ways.");
  app.add_option("SCENE|STATE.hsr", command.scene,
                 std::string(scene_help) + " Or a state that the viewer saved, which ends in .hsr.")
      ->type_name("");
  add_value(
      app, "-a,--algorithm", "SPEC",
      [&command](const auto& option, const auto& text) {
        command.algorithm = with_option_named(option, [&] { return parse_algorithm_spec(text); });
      },
      "The algorithm to begin with, and its settings.");
  add_file(app, "--script", "FILE", command.script,
           "Do what the file says, a line at a time, without a display; exit with 1 at the first expectation "
           "that fails.");
  command.threads = all_cores();
  add_value(
      app, "--threads", "N",
      [&command](const auto& option, const auto& text) {
        command.threads = parse_whole_number(option, text, 1, greatest_threads);
      },
      "How many threads work (default: one per core).");
  app.footer(
      "The viewer is also what hsr alone opens. F1 shows its keys.\n\nExample: hsr view teapot -a painter");
}

void add_render(CLI::App& program, RenderCommand& command) {
  CLI::App& app = *program.add_subcommand("render", "Make one image of a scene with one algorithm.");
  add_picture(app, command.picture);
  command.algorithm = parse_algorithm_spec(default_algorithm().name);
  add_value(
      app, "-a,--algorithm", "SPEC",
      [&command](const auto& option, const auto& text) {
        command.algorithm = with_option_named(option, [&] { return parse_algorithm_spec(text); });
      },
      "The algorithm and its settings, such as zbuffer or zbuffer[depth=unorm16,snap=4] (hsr list "
      "algorithms, hsr list settings; default " +
          std::string(default_algorithm().name) + ").");
  add_file(
      app, "-o,--output", "F.png|F.svg", command.png,
      "Write the picture over the backdrop, in sRGB; as vector graphics where the algorithm paints whole "
      "faces (painter, newell).");
  add_file(
      app, "--layers", "F.exr", command.layers,
      "Write linear R, G, B, A (premultiplied), Z (eye depth, infinite for background) and id (primitive "
      "id, 4294967295 for background).");
  add_file(
      app, "--deep", "F.exr", command.deep,
      "Write the depth list of every pixel as a deep image: R, G, B, A, Z and id of every surface (abuffer, "
      "depthlist, raycast).");
  add_file(app, "--stats", "F.json", command.statistics, "Write camera, times, skipped work and memory.");
  command.backdrop = parse_color("--backdrop", "#eeeeee");
  add_value(
      app, "--backdrop", "COLOUR",
      [&command](const auto& option, const auto& text) { command.backdrop = parse_color(option, text); },
      "What the PNG shows behind the scene: #rrggbb, #rgb, black, gray or white (default #eeeeee).");
  add_value(
      app, "--repeat", "N",
      [&command](const auto& option, const auto& text) {
        command.repeats = parse_whole_number(option, text, 1, greatest_repeats);
      },
      "Render N times, reusing nothing, and report the least time (default 1).");
  app.footer(
      "Without -o, --layers, --deep and --stats the scene is rendered and only the times are shown.\n\n"
      "Example: hsr render teapot -a zbuffer[depth=unorm16] -s 640x480 -o teapot.png");
}

void add_compare(CLI::App& program, CompareCommand& command) {
  CLI::App& app = *program.add_subcommand(
      "compare", "Count the pixels that algorithms get wrong, against the exact answer.");
  add_picture(app, command.picture);
  command.algorithms = parse_algorithm_specs("all");
  add_value(
      app, "-a,--algorithm", "SPEC,...",
      [&command](const auto& option, const auto& text) {
        command.algorithms = with_option_named(option, [&] { return parse_algorithm_specs(text); });
      },
      "Algorithms with their settings, such as zbuffer,painter[key=mean], or all (the default).");
  add_file(app, "--json", "F.json", command.json, "Write all figures.");
  add_file(app, "--heatmap", "DIR", command.heatmaps,
           "Write pictures with legends into a folder: wrong pixels by cause and overdraw of each algorithm, "
           "depth and list length of the scene.");
  app.footer("Example: hsr compare crossing -a zbuffer,zbuffer[depth=unorm16],painter");
}

void add_export(CLI::App& program, ExportCommand& command) {
  CLI::App& app = *program.add_subcommand(
      "export", "Write a scene as triangles in the order of their ids, with the same positions bit for bit.");
  add_scene(app, command.scene);
  add_value(
      app, "-o,--output", "F.obj|F.ply", [&command](const auto&, const auto& text) { command.output = text; },
      "Wavefront OBJ (with an MTL beside it where there are materials) or binary PLY.")
      ->required();
  app.footer("Example: hsr export bumpy-sphere:100 -o sphere.ply");
}

void add_list(CLI::App& program, ListCommand& command) {
  CLI::App& app = *program.add_subcommand("list", "Show what there is to choose from.");
  app.add_option_function<std::string>(
         "WHAT",
         [&command](const std::string& text) {
           using enum ListCommand::Catalogue;
           if (text == "scenes") {
             command.catalogue = scenes;
           } else if (text == "algorithms") {
             command.catalogue = algorithms;
           } else if (text == "settings") {
             command.catalogue = settings;
           } else {
             throw UsageError("WHAT: \"" + text + "\" is not scenes, algorithms or settings");
           }
         },
         "scenes, algorithms or settings.")
      ->required()
      ->type_name("");
  app.add_flag("--json", command.json, "Everything there is to know, as JSON.");
  app.footer("Example: hsr list scenes");
}

/// A message for a subcommand that does not exist; CLI11 would ask for one as if none was given.
void require_known_subcommand(const CLI::App& program, int argc, const char* const* argv) {
  std::vector<std::string> names;
  for (const CLI::App* subcommand : program.get_subcommands({})) names.push_back(subcommand->get_name());
  const std::vector<std::string_view> known(names.begin(), names.end());
  if (argc < 2) return;  // the viewer
  const std::string_view word = argv[1];
  if (word == "-h" || word == "--help" || word == "--version") return;
  if (std::ranges::find(known, word) != known.end()) return;
  throw UsageError("unknown subcommand \"" + std::string(word) + "\"" + what_there_is(word, known));
}

}  // namespace

Command parse_command_line(int argc, const char* const* argv) {
  CLI::App program(
      "hsr: the hidden-surface kit. Which surface is seen at each pixel, by many algorithms, each held "
      "to the exact answer.",
      "hsr");
  program.formatter(std::make_shared<HelpFormatter>());
  program.require_subcommand(0, 1);
  program.set_help_flag("-h,--help", "Show this help.");
  program.set_version_flag("--version", "hsr " HSR_VERSION, "Show the version.");
  program.footer(
      "hsr SUBCOMMAND --help says more. Exit codes: 0 done, 1 the input or the machine failed, 2 wrong "
      "usage.");
  ViewCommand view;
  RenderCommand render;
  CompareCommand compare;
  ExportCommand export_command;
  ListCommand list;
  add_view(program, view);
  add_render(program, render);
  add_compare(program, compare);
  add_export(program, export_command);
  add_list(program, list);
  require_known_subcommand(program, argc, argv);
  try {
    program.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return ShowText{program.help()};
  } catch (const CLI::CallForVersion& version) {
    return ShowText{std::string(version.what()) + "\n"};
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  if (program.got_subcommand("render")) {
    (void)chosen_skips(render.picture.skips_off, {&render.algorithm, 1});
    return render;
  }
  if (program.got_subcommand("compare")) {
    (void)chosen_skips(compare.picture.skips_off, compare.algorithms);
    return compare;
  }
  if (program.got_subcommand("export")) return export_command;
  if (program.got_subcommand("list")) return list;
  return view;
}

}  // namespace hsr
