// CLI11 takes seconds to compile: only the sources of the command line include it.

#include "command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "bench/bench_command_line.h"
#include "exercise/exercise_command_line.h"
#include "help_formatter.h"
#include "lesson/lesson_command_line.h"
#include "nearest_name.h"
#include "option_helpers.h"
#include "scene/errors.h"
#include "skip_choice.h"
#include "stress/stress_command_line.h"

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

/// A picture that is not made here.
void add_elsewhere(CLI::App& app, ViewCommand& command) {
  add_value(
      app, "--picture", "FILE", [&command](const auto&, const auto& text) { command.picture_file = text; },
      "Show the picture of a stream (hsr render --stream), with the same tools.");
  add_value(
      app, "--from", "COMMAND", [&command](const auto&, const auto& text) { command.picture_command = text; },
      "Show the pictures that a program of yours writes: the command is run by the shell for every view and "
      "writes such a stream to its standard output. It finds the view in its environment: HSR_SCENE, "
      "HSR_SIZE (WxH), HSR_EYE, HSR_TARGET, HSR_UP (X,Y,Z), HSR_FOV, HSR_NEAR, HSR_FAR, "
      "HSR_CLIP_FROM_WORLD (16 numbers row by row), and in HSR this program.");
  add_file(app, "--watch", "FILE", command.watched, "Run the command again whenever this file is saved.");
  add_value(
      app, "--time-limit", "SECONDS",
      [&command](const auto& option, const auto& text) {
        command.limits.seconds = parse_number(option, text);
        if (!(command.limits.seconds > 0.0)) throw UsageError(option + ": more than 0 is needed");
      },
      "How long the command may take for a picture (default 10).");
  add_value(
      app, "--memory-limit", "MB",
      [&command](const auto& option, const auto& text) {
        constexpr std::uint64_t megabyte = 1'000'000;
        command.limits.memory =
            megabyte * static_cast<std::uint64_t>(parse_whole_number(option, text, 1, 1'000'000));
      },
      "How much memory it may take (default 4000).");
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
  add_elsewhere(app, command);
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

/// The option -a for a subcommand that takes one algorithm.
void add_algorithm(CLI::App& app, AlgorithmSpec& algorithm) {
  algorithm = parse_algorithm_spec(default_algorithm().name);
  add_value(
      app, "-a,--algorithm", "SPEC",
      [&algorithm](const auto& option, const auto& text) {
        algorithm = with_option_named(option, [&] { return parse_algorithm_spec(text); });
      },
      "The algorithm and its settings, such as zbuffer or zbuffer[depth=unorm16,snap=4] (hsr list "
      "algorithms, hsr list settings; default " +
          std::string(default_algorithm().name) + ").");
}

void add_render(CLI::App& program, RenderCommand& command) {
  CLI::App& app = *program.add_subcommand("render", "Make one image of a scene with one algorithm.");
  add_picture(app, command.picture);
  add_algorithm(app, command.algorithm);
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
  add_file(app, "--stream", "FILE|-", command.stream,
           "Write the picture as a stream that the viewer reads (hsr view --picture): id, depth, colour and "
           "camera; - is standard output, on which then is nothing else.");
  add_value(
      app, "--tell", "lists,steps",
      [&command](const auto& option, const auto& text) { command.tell = parse_tell_choice(option, text); },
      "What else the stream tells: the depth list of every pixel, and every step.");
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

/// What must wait until the size of the picture is known.
struct PlaceTexts {
  std::string x;
  std::string y;
  std::optional<std::string> pixel;
  std::optional<std::string> window;
};

void add_pixel(CLI::App& program, PixelCommand& command, PlaceTexts& texts) {
  CLI::App& app = *program.add_subcommand(
      "pixel", "Say what lies behind one pixel, what an algorithm did there, and why it has its colour.");
  add_picture(app, command.picture);
  app.add_option("X", texts.x, "The pixel's column, from 0 at the left.")->required()->type_name("");
  app.add_option("Y", texts.y, "The pixel's row, from 0 at the top.")->required()->type_name("");
  add_algorithm(app, command.algorithm);
  add_file(app, "--json", "F.json", command.json, "Write all of it, whole lists included.");
  app.footer("Example: hsr pixel crossing 640 300 -a painter");
}

void add_trace(CLI::App& program, TraceCommand& command, PlaceTexts& texts) {
  CLI::App& app = *program.add_subcommand("trace", "Tell the steps of an algorithm, one sentence for each.");
  add_picture(app, command.picture);
  add_algorithm(app, command.algorithm);
  add_value(
      app, "--pixel", "X,Y", [&texts](const auto&, const auto& text) { texts.pixel = text; },
      "Only steps at this pixel, and those about the triangles there.");
  add_value(
      app, "--window", "X,Y,W,H", [&texts](const auto&, const auto& text) { texts.window = text; },
      "Only steps at the pixels of this window: its upper left pixel, width and height.");
  add_value(
      app, "--face", "ID",
      [&command](const auto& option, const auto& text) {
        command.face =
            static_cast<std::uint32_t>(parse_whole_number(option, text, 0, std::numeric_limits<int>::max()));
      },
      "Only steps about the triangles of this face (a polygon of the file, counted from 0).");
  const auto step = [&](const char* name, std::optional<std::uint64_t>& value, const char* help) {
    add_value(
        app, name, "K",
        [&value](const auto& option, const auto& text) {
          value = parse_count(option, text);
          if (*value == 0) throw UsageError(option + ": steps are counted from 1");
        },
        help);
  };
  step("--from", command.from, "The first step to tell, counted from 1.");
  step("--to", command.to, "The last step to tell.");
  add_file(app, "--jsonl", "F.jsonl", command.jsonl, "Write every step, a JSON object on each line.");
  add_file(app, "--gif", "F.gif", command.gif, "Write an animation of the picture while the steps are made.");
  command.backdrop = parse_color("--backdrop", "#eeeeee");
  add_value(
      app, "--backdrop", "COLOUR",
      [&command](const auto& option, const auto& text) { command.backdrop = parse_color(option, text); },
      "What the animation shows behind the scene (default #eeeeee).");
  app.footer("Example: hsr trace three-bars -a painter --pixel 640,360");
}

/// The parts of the commands that depend on the size of the picture. Throws UsageError.
void finish(PixelCommand& command, const PlaceTexts& texts) {
  const Size size = command.picture.size;
  (void)chosen_skips(command.picture.skips_off, {&command.algorithm, 1});
  command.pixel.i = parse_whole_number("X", texts.x, 0, size.width - 1);
  command.pixel.j = parse_whole_number("Y", texts.y, 0, size.height - 1);
}

void finish(TraceCommand& command, const PlaceTexts& texts) {
  const Size size = command.picture.size;
  (void)chosen_skips(command.picture.skips_off, {&command.algorithm, 1});
  if (texts.pixel && texts.window) throw UsageError("--pixel and --window cannot both be given");
  if (texts.pixel) command.window = parse_pixel("--pixel", *texts.pixel, size);
  if (texts.window) command.window = parse_window("--window", *texts.window, size);
  if (command.from && command.to && *command.from > *command.to) {
    throw UsageError("--to: " + std::to_string(*command.to) + " lies before --from, which is " +
                     std::to_string(*command.from));
  }
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
  PixelCommand pixel;
  PlaceTexts pixel_texts;
  TraceCommand trace;
  PlaceTexts trace_texts;
  ExportCommand export_command;
  BenchCommand bench;
  StressCommand stress;
  stress.threads = all_cores();
  ListCommand list;
  LessonCommand lesson;
  lesson.threads = all_cores();
  ExerciseCommand exercise;
  add_view(program, view);
  add_render(program, render);
  add_compare(program, compare);
  add_pixel(program, pixel, pixel_texts);
  add_trace(program, trace, trace_texts);
  add_export(program, export_command);
  add_bench(program, bench);
  add_stress(program, stress);
  add_list(program, list);
  add_lesson(program, lesson);
  add_exercise(program, exercise);
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
  if (program.got_subcommand("pixel")) {
    finish(pixel, pixel_texts);
    return pixel;
  }
  if (program.got_subcommand("trace")) {
    finish(trace, trace_texts);
    return trace;
  }
  if (program.got_subcommand("export")) return export_command;
  if (program.got_subcommand("bench")) return bench;
  if (program.got_subcommand("stress")) return stress;
  if (program.got_subcommand("list")) return list;
  if (program.got_subcommand("lesson")) return lesson;
  if (program.got_subcommand("exercise")) return exercise;
  if (view.picture_file && view.picture_command)
    throw UsageError("--picture and --from cannot both be given");
  return view;
}

}  // namespace hsr
