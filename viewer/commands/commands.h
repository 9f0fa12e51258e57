#pragma once

#include <iosfwd>

#include "options.h"

namespace hsr {

// One function per subcommand. Each writes what it has to say to `out` and throws UsageError or
// InputError when it cannot do what was asked.

/// hsr render: one image.
void run(const RenderCommand& command, std::ostream& out);

/// hsr compare: several algorithms against the exact answer.
void run(const CompareCommand& command, std::ostream& out);

/// hsr pixel: the depth list and the history of one pixel.
void run(const PixelCommand& command, std::ostream& out);

/// hsr trace: an algorithm's steps as sentences, data and an animation.
void run(const TraceCommand& command, std::ostream& out);

/// hsr export: the scene as triangles.
void run(const ExportCommand& command, std::ostream& out);

/// hsr list: what there is to choose from.
void run(const ListCommand& command, std::ostream& out);

/// hsr bench: run times, beside other programs.
void run(const BenchCommand& command, std::ostream& out);

/// hsr stress: where each algorithm breaks.
void run(const StressCommand& command, std::ostream& out);

/// hsr lesson: the course.
void run(const LessonCommand& command, std::ostream& out);

/// hsr exercise: the exercises of the course.
void run(const ExerciseCommand& command, std::ostream& out);

/// hsr view: the window.
void run(const ViewCommand& command, std::ostream& out);

/// A text that was asked for.
void run(const ShowText& command, std::ostream& out);

}  // namespace hsr
