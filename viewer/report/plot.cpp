#include "report/plot.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <tuple>

#include "child_process.h"
#include "report/plot_layout.h"
#include "report/table.h"
#include "scene/atomic_file.h"

namespace hsr::report {
namespace {

constexpr std::array colors = {"#0072B2", "#D55E00", "#009E73", "#000000", "#CC79A7", "#56B4E9", "#E69F00"};

std::string number(double value) { return number_text(value, 9); }

/// As gnuplot reads a text: between single quotes, with each quote in it doubled.
std::string gnuplot_text(std::string_view text) {
  std::string result = "'";
  for (const char letter : text) result.append(letter == '\'' ? "''" : std::string(1, letter));
  return result + "'";
}

/// A place of the picture as gnuplot counts it, from 0 to 1.
std::string across(double pixels) { return "screen " + number(pixels / picture_width); }
std::string up(double pixels, const Plot& plot) { return "screen " + number(pixels / height_of(plot)); }

std::string ticks_script(const char* axis, const Scale& scale) {
  std::string script = std::string("set ") + axis + "tics (";
  for (std::size_t k = 0; k < scale.ticks.size(); ++k) {
    script += (k == 0 ? "" : ", ") + gnuplot_text(scale.ticks[k].second) + " " + number(scale.ticks[k].first);
  }
  script += ")\n";
  script += std::string("set ") + axis + "range [" + number(scale.low) + ":" + number(scale.high) + "]\n";
  return script + (scale.logarithmic ? "set" : "unset") + " logscale " + axis + "\n";
}

std::string color(const Series& series) {
  return std::string(" linecolor rgb '") + colors[series.look.color % colors.size()] + "'";
}

std::string style(const Series& series) {
  // Gnuplot's filled circle, square, triangles, diamond and pentagon, the same open, and crosses.
  constexpr std::array shapes = {7, 5, 9, 13, 11, 15, 6, 4, 8, 12, 10, 14, 2, 1};
  const std::string mark =
      " pointtype " + std::to_string(shapes[series.look.shape % shapes.size()]) + " pointsize mark";
  const std::string line = std::string(" linewidth 2") + (series.dashed ? " dashtype 2" : "");
  if (series.line && series.marks) return "with linespoints" + color(series) + mark + line;
  return series.line ? "with lines" + color(series) + line
                     : "with points" + color(series) + mark + " linewidth 2";
}

bool spreads(const Series& series, std::optional<Spread> Point::*along) {
  return std::ranges::any_of(series.points,
                             [along](const Point& point) { return (point.*along).has_value(); });
}

/// What draws one series, and what its spreads are drawn with below it.
std::string series_script(const Series& series, std::size_t block) {
  const std::string data = "data index " + std::to_string(block);
  std::string script;
  const std::string bars = " pointtype 0 linewidth 1.5" + color(series) + " notitle, \\\n  ";
  if (spreads(series, &Point::x_spread)) script += data + " using 1:2:3:4 with xerrorbars" + bars;
  if (spreads(series, &Point::y_spread)) script += data + " using 1:2:5:6 with yerrorbars" + bars;
  return script + data + " using 1:2 " + style(series) + " notitle";
}

/// The legend, as a plot without axes whose points are nowhere: as high as the picture, so that all entries
/// stand below each other.
std::string legend_script(const Plot& plot) {
  std::vector<std::string_view> names;
  std::string entries;
  for (const Panel& panel : plot.panels) {
    for (const Series& series : panel.series) {
      if (series.name.empty() || std::ranges::find(names, series.name) != names.end()) continue;
      names.push_back(series.name);
      entries += (names.size() == 1 ? "plot " : ", \\\n  ") + ("NaN " + style(series)) + " title " +
                 gnuplot_text(series.name);
    }
  }
  if (names.empty()) return {};
  return "\nunset label\nunset arrow\nunset border\nunset tics\nunset xlabel\nunset ylabel\nunset title\n"
         "set lmargin at screen 0.5\nset rmargin at screen 1\nset bmargin at screen 0\nset tmargin at screen "
         "1\n"
         "unset logscale\nset xrange [0:1]\nset yrange [0:1]\n"
         "set key at screen 0.99, " +
         up(height_of(plot) - 50.0, plot) + " right top Left reverse samplen 2 spacing 1.25 noenhanced\n" +
         entries + "\n";
}

std::string panel_script(const Plot& plot, std::size_t k, std::size_t first_block) {
  const Panel& panel = plot.panels[k];
  const Scales scales(panel);
  const Area area = area_of(plot, k);
  std::string script = "\nunset label\nunset arrow\n";
  if (k == 0)
    script += "set label " + gnuplot_text(plot.title) + " at screen 0.015, " +
              up(height_of(plot) - 25.0, plot) + " left font title_font\n";
  script += "set title " + gnuplot_text(panel.title) + "\n";
  script += "set xlabel " + gnuplot_text(panel.x.label) + " offset 0,0.4\n";
  script += "set ylabel " + gnuplot_text(panel.y.label) + "\n";
  script += ticks_script("x", scales.x) + ticks_script("y", scales.y);
  script +=
      "set lmargin at " + across(area.left) + "\nset rmargin at " + across(area.left + area.width) + "\n";
  script += "set bmargin at " + up(area.bottom, plot) + "\nset tmargin at " +
            up(area.bottom + area.height, plot) + "\n";
  for (const PlacedLabel& label : place_labels(panel, scales, area)) {
    script += "set label " + gnuplot_text(label.text) + " at " + across(label.area.left) + ", " +
              up(label.area.bottom + label.area.height / 2.0, plot) + " left font small_font\n";
    if (!label.led) continue;
    const bool above = label.area.bottom > label.point_y;
    script += "set arrow from " + across(label.point_x) + ", " + up(label.point_y, plot) + " to " +
              across(label.point_x) + ", " +
              up(above ? label.area.bottom : label.area.bottom + label.area.height, plot) +
              " nohead linecolor rgb '#808080' linewidth 1\n";
  }
  std::vector<std::string> drawn;
  for (std::size_t s = 0; s < panel.series.size(); ++s)
    drawn.push_back(series_script(panel.series[s], first_block + s));
  if (drawn.empty()) drawn.emplace_back("NaN notitle");
  for (std::size_t s = 0; s < drawn.size(); ++s) script += (s == 0 ? "plot " : ", \\\n  ") + drawn[s];
  return script + "\n";
}

/// As the shell reads a word.
std::string shell_word(const std::string& text) {
  std::string result = "'";
  for (const char letter : text) result.append(letter == '\'' ? "'\\''" : std::string(1, letter));
  return result + "'";
}

std::filesystem::path draw(const std::filesystem::path& folder, const std::string& name,
                           const std::string& format) {
  const ChildRun run = run_command("cd " + shell_word(folder.string()) + " && gnuplot -e \"format='" +
                                       format + "'\" " + shell_word(name + ".gnuplot"),
                                   {}, {60.0, 4'000'000'000, 1'000'000});
  return run.ended.empty() ? folder / (name + "." + format) : std::filesystem::path();
}

void write_whole(const std::filesystem::path& file, const std::string& text) {
  write_file_atomically(file, [&](const std::filesystem::path& temporary) { write_bytes(temporary, text); });
}

std::string data_line(const Point& point, const Scales& scales) {
  const Spread x = point.x_spread.value_or(Spread{point.x, point.x});
  const Spread y = point.y_spread.value_or(Spread{point.y, point.y});
  std::string line = number(scales.x.place(point.x)) + " " + number(scales.y.place(point.y));
  for (const double value : {x.low, x.high}) line += " " + number(scales.x.place(value));
  for (const double value : {y.low, y.high}) line += " " + number(scales.y.place(value));
  return line + "\n";
}

}  // namespace

bool gnuplot_present() { return run_command("command -v gnuplot >/dev/null", {}, {}).ended.empty(); }

std::string plot_data(const Plot& plot) {
  std::string data =
      "# x, y, least and greatest x, least and greatest y\n"
      "# 0 on a logarithmic axis is given the place at which it is drawn\n";
  for (const Panel& panel : plot.panels) {
    const Scales scales(panel);
    for (const Series& series : panel.series) {
      data += "# " + panel.title + ": " + series.name + "\n";
      std::string lines;
      for (const Point& point : series.points) {
        if (scales.take(point)) lines += data_line(point, scales);
      }
      // A block without a line would shift the numbers of those after it.
      data += (lines.empty() ? "NaN NaN NaN NaN NaN NaN\n" : lines) + "\n\n";
    }
  }
  return data;
}

std::string plot_script(const Plot& plot) {
  const std::string size = number(picture_width) + "," + number(height_of(plot));
  std::string script =
      "# Draws " + plot.name + ".svg, or a PNG: gnuplot -e \"format='png'\" " + plot.name + ".gnuplot\n";
  script += "if (!exists(\"format\")) format = 'svg'\n";
  script += "data = " + gnuplot_text(plot.name + ".dat") + "\n";
  // The sizes of letters are pixels for SVG and points, 4/3 of a pixel, for PNG; those of marks differ too.
  const auto font = [](int pixels, double scale) { return "'DejaVu Sans," + number(pixels * scale) + "'"; };
  for (const auto& [format, scale, mark, terminal] :
       {std::tuple{"svg", 1.0, "0.75", "svg dynamic background rgb 'white'"},
        std::tuple{"png", 0.75, "1.3", "pngcairo"}}) {
    script += std::string("if (format eq '") + format + "') { set terminal " + terminal + " size " + size +
              " noenhanced font " + font(font_pixels, scale) +
              "; small_font = " + font(small_font_pixels, scale) +
              "; title_font = " + font(font_pixels + 4, scale) + "; mark = " + mark + " }\n";
  }
  script += "set output " + gnuplot_text(plot.name + ".") + ".format\n";
  script += "set encoding utf8\nset border 3 linewidth 1.5\nset tics nomirror out\n";
  script += "set grid linecolor rgb '#D0D0D0' linewidth 1\n";
  script += "unset key\n";
  script += "set multiplot\n";
  std::size_t block = 0;
  for (std::size_t k = 0; k < plot.panels.size(); ++k) {
    script += panel_script(plot, k, block);
    block += plot.panels[k].series.size();
  }
  return script + legend_script(plot) + "unset multiplot\n";
}

PlotFiles write_plot(const Plot& plot, const std::filesystem::path& folder) {
  PlotFiles files = {folder / (plot.name + ".dat"), folder / (plot.name + ".gnuplot"), {}, {}};
  write_whole(files.data, plot_data(plot));
  write_whole(files.script, plot_script(plot));
  if (!gnuplot_present()) return files;
  files.svg = draw(folder, plot.name, "svg");
  files.png = draw(folder, plot.name, "png");
  return files;
}

}  // namespace hsr::report
