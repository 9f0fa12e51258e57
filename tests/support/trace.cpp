#include "support/trace.h"

#include <doctest/doctest.h>

#include <memory>
#include <optional>

#include "scene/catalog.h"
#include "support/render.h"

namespace hsr::test {

TracedRun traced_run(const View& view, std::string_view spec_text, const RenderOptions& options) {
  const AlgorithmSpec spec = parse_algorithm_spec(spec_text);
  const std::shared_ptr<Renderer> renderer = spec.algorithm->prepare(*view.scene, spec.settings, options);
  return [&view, renderer, options](const EventListener& listener) {
    Frame frame(view.width, view.height);
    renderer->trace(view, options, listener, frame);
  };
}

void for_each_traced(const std::vector<std::string>& scenes, int width, int height,
                     const std::function<void(const View&, const std::string&)>& check) {
  for (const std::string& name : scenes) {
    const std::optional<Scene> scene = make_built_in_scene(name);
    REQUIRE(scene);
    const View view = make_view(*scene, *scene->camera, width, height);
    for (const Algorithm* algorithm : algorithm_catalog()) {
      for (const std::string& spec : every_setting(*algorithm)) {
        CAPTURE(name);
        CAPTURE(spec);
        check(view, spec);
      }
    }
  }
}

}  // namespace hsr::test
