#include "exercise/exercise_picture.h"

#include <cstdlib>
#include <fstream>
#include <iostream>

#include "exercise/accident.h"
#include "exercise/scene_data.h"
#include "picture.h"
#include "scene/errors.h"

namespace hsr {

void write_exercise_picture(const ExerciseCatalog& catalog, const Exercise& exercise,
                            const Workspace& workspace, const CheckLimits& limits, std::ostream& out) {
  const char* name = std::getenv("HSR_SCENE");
  if (exercise.scenes.empty() || name == nullptr)
    throw UsageError("picture: this is what hsr exercise view has the viewer run; " + exercise.name +
                     (exercise.scenes.empty() ? " makes no pictures" : " needs HSR_SCENE"));
  // A folder apart from that of hsr exercise check, which may be building at the same time.
  const std::filesystem::path folder = workspace.build_of(exercise) / "viewer";
  const ExerciseBuild build = build_exercise(catalog, exercise, workspace.work_of(exercise), folder, true);
  std::cerr << build.messages;
  if (!build.done) throw InputError("it does not compile");
  ReadReport report;
  const Scene scene = open_scene(name, report, {});
  const std::filesystem::path data = std::filesystem::absolute(folder) / "view.bin";
  write_view_data(view_from_environment(scene), data);
  const ProgramEnd end = run_built(build, "picture", limits, data);
  std::cerr << end.printed;
  if (!end.ended.empty()) {
    const Accident accident = accident_of(exercise, end.ended, end.said);
    throw InputError(exercise.file_name() + ": " + accident.what +
                     (accident.place.empty() ? "" : " (" + accident.place + ")"));
  }
  out << std::ifstream(end.results, std::ios::binary).rdbuf() << std::flush;
}

}  // namespace hsr
