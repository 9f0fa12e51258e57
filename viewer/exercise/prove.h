#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "exercise/check.h"
#include "exercise/workspace.h"

namespace hsr {

/// What is wrong with an exercise itself, a sentence each; empty if its starter compiles without warnings and
/// fails, both solutions pass, and every mistake fails and is the one that is named. Built in `folder`.
std::vector<std::string> faults_of(const ExerciseCatalog& catalog, const Exercise& exercise,
                                   const std::filesystem::path& folder, const CheckLimits& limits,
                                   bool sanitize);

/// Tells of each exercise whether it is sound, and what is wrong with it. Throws InputError if one is not.
void prove_exercises(const ExerciseCatalog& catalog, const std::vector<const Exercise*>& exercises,
                     const Workspace& workspace, const CheckLimits& limits, bool sanitize, std::ostream& out);

}  // namespace hsr
