#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hsr::report {

/// How a series looks: a colour that colour-blind viewers can tell apart (Okabe and Ito 2008, without the
/// yellow that nobody sees on white) and a shape of its own, so that grey print does as well. Any whole
/// numbers; equal ones look equal in every plot.
struct Look {
  unsigned color = 0;  ///< one of 7
  unsigned shape = 0;  ///< one of 14
};

/// From the least to the greatest of what was measured.
struct Spread {
  double low = 0.0;
  double high = 0.0;
};

struct Point {
  double x = 0.0;
  double y = 0.0;
  std::optional<Spread> x_spread = {};
  std::optional<Spread> y_spread = {};
  std::string label = {};  ///< written beside it, where there is room
};

struct Series {
  std::string name;  ///< in the legend; series of one name share an entry. Empty: none
  Look look;
  std::vector<Point> points;
  bool marks = true;    ///< a mark at every point
  bool line = false;    ///< a line from point to point, in their order
  bool dashed = false;  ///< that line
};

struct Axis {
  std::string label;         ///< with its unit: "time (ms)"
  bool logarithmic = false;  ///< then a value of 0 stands below all others, at a tick called 0
  std::vector<std::string> categories = {};  ///< if given, value k stands for categories[k]; y only
};

struct Panel {
  std::string title;
  Axis x;
  Axis y;
  std::vector<Series> series;
};

/// Some panels with one legend to their right, as a picture 1280 pixels wide.
struct Plot {
  std::string name;   ///< of its files, without ending
  std::string title;  ///< one line; what there is to see
  std::vector<Panel> panels;
  std::size_t columns = 1;
};

/// What became of a plot. A picture that was not drawn is an empty path.
struct PlotFiles {
  std::filesystem::path data;
  std::filesystem::path script;
  std::filesystem::path svg;
  std::filesystem::path png;
};

/// Whether gnuplot is installed.
bool gnuplot_present();

/// Writes NAME.dat and NAME.gnuplot into `folder` and, where gnuplot is installed, draws NAME.svg and
/// NAME.png with it. Points that are not finite, and those below 0 on a logarithmic axis, are left out.
/// Throws InputError if the folder cannot be written to.
PlotFiles write_plot(const Plot& plot, const std::filesystem::path& folder);

/// The data of a plot, a block for each series, and the script that draws them: format="png" chooses PNG.
std::string plot_data(const Plot& plot);
std::string plot_script(const Plot& plot);

}  // namespace hsr::report
