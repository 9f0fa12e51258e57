#pragma once

#include <memory>
#include <string>

#include "algorithm.h"
#include "child_process.h"
#include "trace/picture_stream.h"
#include "window/results/model.h"

namespace hsr::window {

/// Which picture of another process is meant.
struct ElsewhereKey {
  Elsewhere source;
  std::uint64_t run = 0;  ///< counts how often it was asked for anew
  bool operator==(const ElsewhereKey&) const = default;
};

/// A picture that came from elsewhere, and what is told of its coming.
struct FromElsewhere {
  ToldPicture picture;  ///< with colours, if need be by the triangles it shows
  std::string said;     ///< the end of what the command wrote on its standard error
  double seconds = 0.0;
};

/// Reads a picture's file for a scene. Throws InputError.
FromElsewhere read_elsewhere(const ElsewhereKey& key, const Model& model);

/// Runs the command for a view and reads what it writes. Throws InputError that says how it ended, and what
/// it said last.
FromElsewhere run_elsewhere(const ElsewhereKey& key, const Model& model, const View& view,
                            const ChildLimits& limits, const Progress& progress);

/// The row that stands for a program that is in no catalogue. Its renderers are made by told_renderer.
const AlgorithmSpec& program_spec();

/// A renderer whose frame and steps are those that were told.
std::unique_ptr<Renderer> told_renderer(std::shared_ptr<const FromElsewhere> told);

}  // namespace hsr::window
