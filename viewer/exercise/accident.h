#pragma once

#include <string>

#include "exercise/check.h"

namespace hsr {

/// What befell a run that did not come to its end: in words, and where in the student's file. `ended` is how
/// the process ended (ChildRun::ended), `said` what it and its sanitizers wrote on standard error.
Accident accident_of(const Exercise& exercise, const std::string& ended, const std::string& said);

}  // namespace hsr
