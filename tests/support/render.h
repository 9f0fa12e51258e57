#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "algorithm.h"
#include "exact/errors.h"
#include "frame/frame.h"
#include "view/view.h"

namespace hsr::test {

/// The frame that an algorithm, named as on the command line, makes of a view.
Frame render(const View& view, std::string_view spec_text, const RenderOptions& options = {});

/// The specs "name" with its default settings, then with each other choice of each setting, and
/// with all parts of a setting but one.
std::vector<std::string> every_setting(const Algorithm& algorithm);
/// The same with depth lists, where the algorithm keeps them.
Frame render_with_lists(const View& view, std::string_view spec_text, const RenderOptions& options = {});

/// The errors of that frame against the exact answer.
exact::Errors errors_of(const View& view, std::string_view spec_text);

}  // namespace hsr::test
