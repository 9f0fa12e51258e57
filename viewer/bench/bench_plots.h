#pragma once

#include <vector>

#include "bench/bench_report.h"
#include "report/plot.h"

namespace hsr::bench {

/// A plot, and what it shows in words.
struct DescribedPlot {
  report::Plot plot;
  std::string says;
};

/// Time against error on one scene, with the Pareto front.
DescribedPlot tradeoff_plot(const Tradeoff& tradeoff);

/// Time over what grows, with the law of each in the legend. Without panels if nothing was measured.
DescribedPlot growth_plot(const std::vector<RunRecord>& runs, Question question);

/// What each skip saves, those that save most first. Without panels if no skip was left out.
DescribedPlot skip_plot(const std::vector<RunRecord>& runs);

/// Build, memory and trace of each structure of ray casting. Without panels if none was measured.
DescribedPlot structure_plot(const std::vector<RunRecord>& runs);

/// Operations and times of the table of 1974. Without panels if it was not made.
DescribedPlot plot_of_1974(const std::vector<Cost1974>& costs);

/// The runs of the trade-off that tell structures apart: those of ray casting, alike in all else.
std::vector<const RunRecord*> structure_runs(const std::vector<RunRecord>& runs);

}  // namespace hsr::bench
