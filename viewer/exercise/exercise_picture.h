#pragma once

#include <ostream>

#include "exercise/check.h"
#include "exercise/workspace.h"

namespace hsr {

/// Builds the student's algorithm and writes its picture of the view that the environment names, as a stream,
/// to `out`. What it wrote itself, and what the compiler said, goes to standard error. Throws InputError that
/// says what went wrong, and where in the student's file.
void write_exercise_picture(const ExerciseCatalog& catalog, const Exercise& exercise,
                            const Workspace& workspace, const CheckLimits& limits, std::ostream& out);

}  // namespace hsr
