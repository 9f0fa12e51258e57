#pragma once

#include <chrono>
#include <ostream>
#include <string>

#include "options.h"
#include "progress_bar.h"
#include "scene/read_scene.h"
#include "scene/scene.h"
#include "view/view.h"

namespace hsr {

/// A scene that was asked for by name.
struct LoadedScene {
  Scene scene;
  std::size_t warnings = 0;  ///< how many the reader had
  double milliseconds = 0.0;
};

/// Makes the built-in scene or reads the file that `name` stands for; warnings go to standard error.
/// A built-in scene goes before a file of the same name, which is reached as ./NAME. Throws
/// UsageError for an unknown name or a parameter out of range, InputError for a file that cannot be
/// used.
LoadedScene load_scene(const std::string& name, ProgressBar& bar);

/// The same without a word to anybody: what the reader had to say goes to `report`.
Scene open_scene(const std::string& name, ReadReport& report, const Progress& progress);

/// The view that the options ask for: the scene's own camera, or one that frames the scene, with the
/// parts replaced that were given. Throws UsageError when it is impossible, InputError when the
/// machine has no memory for a picture of that size.
View choose_view(const Scene& scene, const PictureOptions& options);

/// Milliseconds of wall time.
class Stopwatch {
 public:
  double milliseconds() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace hsr
