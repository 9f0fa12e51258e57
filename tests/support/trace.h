#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "algorithm.h"
#include "frame/frame.h"
#include "scene/scene.h"
#include "trace/filter.h"
#include "view/view.h"

namespace hsr::test {

/// The traced run of an algorithm, named as on the command line. The view must outlive it.
TracedRun traced_run(const View& view, std::string_view spec_text, const RenderOptions& options = {});

/// Calls check(view, spec) for each of the built-in scenes at the given size, by each algorithm, in each
/// setting.
void for_each_traced(const std::vector<std::string>& scenes, int width, int height,
                     const std::function<void(const View&, const std::string&)>& check);

}  // namespace hsr::test
