#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "scene/progress.h"
#include "scene/scene.h"
#include "view/view.h"
#include "window/state.h"

namespace hsr::window {

/// Which scene is meant, and how it was changed.
struct ModelKey {
  std::string scene;  ///< as on the command line
  std::vector<MovedCorner> moved;
  bool operator==(const ModelKey&) const = default;
};

/// A scene in memory, and what every view of it needs.
struct Model {
  std::uint64_t number = 0;  ///< no two models of a run have the same
  ModelKey key;
  std::shared_ptr<const Scene> scene;
  std::vector<std::string> warnings;
  BoundingSphere sphere;
  double load_ms = 0.0;
};

/// Makes or reads the scene. `unmoved` may be the same scene without moved corners, which then need not
/// be read again. Throws UsageError and InputError.
Model make_model(const ModelKey& key, std::uint64_t number, const std::shared_ptr<const Scene>& unmoved,
                 const Progress& progress);

/// What one camera makes of one model. Two views with the same key are the same.
struct ViewKey {
  std::uint64_t model = 0;
  Camera camera;
  Extent size;
};
bool operator==(const ViewKey& a, const ViewKey& b);

}  // namespace hsr::window
