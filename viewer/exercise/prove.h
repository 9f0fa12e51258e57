#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "exercise/check.h"

namespace hsr {

/// What is wrong with an exercise itself, a sentence each; empty if its starter compiles without warnings and
/// fails, both solutions pass, and every mistake fails and is the one that is named. Built in `folder`.
std::vector<std::string> faults_of(const ExerciseCatalog& catalog, const Exercise& exercise,
                                   const std::filesystem::path& folder, const CheckLimits& limits,
                                   bool sanitize);

}  // namespace hsr
