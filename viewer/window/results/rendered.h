#pragma once

#include <list>
#include <memory>
#include <set>
#include <string>

#include "algorithm.h"
#include "window/results/bitmap.h"
#include "window/results/elsewhere.h"
#include "window/results/model.h"

namespace hsr::window {

/// Which picture is meant.
struct PictureKey {
  ViewKey view;
  std::string algorithm;  ///< with its settings, AlgorithmSpec::text
  std::set<std::string, std::less<>> skips_off;
  std::optional<ElsewhereKey> elsewhere;  ///< then made by another process
  bool operator==(const PictureKey&) const = default;
};

/// A picture that an algorithm made.
struct Rendered {
  std::shared_ptr<const Scene> scene;  ///< what `view` points to
  View view;
  Frame frame;
  ScreenPicture screen;  ///< the same for the screen
  RenderReport report;
  double prepare_ms = 0.0;  ///< what no camera changes; 0 if it was done for an earlier picture
  double render_ms = 0.0;
  std::shared_ptr<const FromElsewhere> told;  ///< null if it was made here
};

/// The algorithm that makes the picture, with its settings.
AlgorithmSpec spec_of(const PictureKey& key);

/// Renderers that were prepared for a scene, the last few of them: another camera does not need another
/// hierarchy. For one thread at a time.
class PreparedRenderers {
 public:
  struct Entry {
    std::uint64_t model = 0;
    std::string algorithm;
    std::set<std::string, std::less<>> skips_off;
    std::shared_ptr<const Scene> scene;  // outlives the renderer
    std::unique_ptr<Renderer> renderer;
    double prepare_ms = 0.0;
  };

  /// Throws InputError if the progress function asks to stop, as half a hierarchy is of no use.
  Entry& get(const Model& model, const PictureKey& key, const RenderOptions& options);

 private:
  std::list<Entry> entries_;  // the latest first
};

/// What a piece of work is given beside its key.
struct Surroundings {
  std::shared_ptr<const Model> model;
  int threads = 1;
  ChildLimits limits = {};
  glm::vec3 backdrop{0.0F};                             ///< of the pictures on the screen
  std::shared_ptr<const FromElsewhere> told = nullptr;  ///< the picture in question, if it is from elsewhere
};

/// The view that a key means. Throws UsageError.
View view_of(const Surroundings& given, const ViewKey& key);

/// Makes the picture.
Rendered render_picture(const PictureKey& key, const Surroundings& given, PreparedRenderers& prepared,
                        const Progress& progress);

}  // namespace hsr::window
