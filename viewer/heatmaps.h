#pragma once

#include <filesystem>
#include <vector>

#include "algorithm.h"
#include "exact/exact_answer.h"
#include "failures/ordering_failures.h"

namespace hsr {

/// Writes pictures of a view, each with a legend, into a folder: how long the exact depth lists are, how
/// deep the exact answer is.
void write_scene_heatmaps(const View& view, const exact::ExactAnswer& exact, const exact::Nearest& nearest,
                          const RenderOptions& options, const std::filesystem::path& folder);

/// The same of what an algorithm made of the view: its wrong pixels by cause, and how often it wrote each
/// pixel (overdraw), as its own steps tell.
void write_algorithm_heatmaps(const View& view, const AlgorithmSpec& spec, const Frame& frame,
                              const OrderingFailures& failures, const RenderOptions& options,
                              const std::filesystem::path& folder);

}  // namespace hsr
