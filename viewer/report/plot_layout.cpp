#include "report/plot_layout.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "text_layout.h"

namespace hsr::report {
namespace {

constexpr double title_height = 50.0;

/// As wide as its longest name needs it.
double legend_width(const Plot& plot) {
  constexpr double letter = 0.57 * font_pixels;
  constexpr double sample = 75.0;
  std::size_t longest = 0;
  for (const Panel& panel : plot.panels) {
    for (const Series& series : panel.series) longest = std::max(longest, text_width(series.name));
  }
  return longest == 0 ? 0.0 : sample + letter * static_cast<double>(longest);
}

/// What a y axis needs for its ticks and its label.
double left_of_axis(const Panel& panel) {
  constexpr double letter = 0.57 * font_pixels;
  std::size_t longest = 0;
  for (const auto& [value, text] : Scales(panel).y.ticks) longest = std::max(longest, text_width(text));
  const double label = panel.y.label.empty() ? 25.0 : 55.0;
  return label + letter * static_cast<double>(longest);
}

/// Beside, above and below a point; then farther above and below.
std::vector<Area> places_round(double x, double y, double width) {
  constexpr double line = 1.2 * small_font_pixels;
  constexpr double away = 10.0;
  std::vector<Area> places = {{x + away, y + 4.0, width, line},
                              {x + away, y - line - 4.0, width, line},
                              {x - away - width, y + 4.0, width, line},
                              {x - away - width, y - line - 4.0, width, line}};
  for (int level = 1; level <= 6; ++level) {
    for (const double shift : {0.5, 0.1, 0.9}) {
      places.push_back({x - shift * width, y + level * 1.5 * line, width, line});
      places.push_back({x - shift * width, y - (level * 1.5 + 1.0) * line, width, line});
    }
  }
  return places;
}

std::size_t rows_of(const Plot& plot) {
  return std::max<std::size_t>(1, (plot.panels.size() + plot.columns - 1) / plot.columns);
}

void add(std::vector<double>& values, double value, const std::optional<Spread>& spread) {
  values.push_back(value);
  if (spread) values.insert(values.end(), {spread->low, spread->high});
}

std::vector<double> values_of(const Panel& panel, bool along_x) {
  std::vector<double> values;
  for (const Series& series : panel.series) {
    for (const Point& point : series.points)
      add(values, along_x ? point.x : point.y, along_x ? point.x_spread : point.y_spread);
  }
  return values;
}

}  // namespace

Scales::Scales(const Panel& panel)
    : x(scale_of(panel.x, values_of(panel, true))), y(scale_of(panel.y, values_of(panel, false))) {}

double height_of(const Plot& plot) {
  constexpr double one_panel = 670.0;
  constexpr double one_of_several = 440.0;
  constexpr double without_categories = 150.0;
  constexpr double category_height = 26.0;
  std::size_t most_categories = 0;
  for (const Panel& panel : plot.panels)
    most_categories = std::max(most_categories, panel.y.categories.size());
  const double panel = std::max(plot.panels.size() == 1 ? one_panel : one_of_several,
                                without_categories + category_height * static_cast<double>(most_categories));
  return title_height + panel * static_cast<double>(rows_of(plot));
}

Area area_of(const Plot& plot, std::size_t k) {
  constexpr double above = 45.0;
  constexpr double below = 85.0;
  constexpr double right = 30.0;
  const double usable = picture_width - legend_width(plot);
  const double cell_width = usable / static_cast<double>(plot.columns);
  const double cell_height = (height_of(plot) - title_height) / static_cast<double>(rows_of(plot));
  const double left = left_of_axis(plot.panels[k]);
  const auto column = static_cast<double>(k % plot.columns);
  const auto row = static_cast<double>(k / plot.columns);
  return {column * cell_width + left, height_of(plot) - title_height - (row + 1.0) * cell_height + below,
          cell_width - left - right, cell_height - below - above};
}

std::vector<PlacedLabel> place_labels(const Panel& panel, const Scales& scales, const Area& area) {
  constexpr double mark = 12.0;
  constexpr double letter = 0.6 * small_font_pixels;
  const auto at = [&](const Point& point) {
    return std::pair{area.left + area.width * scales.x.share(scales.x.place(point.x)),
                     area.bottom + area.height * scales.y.share(scales.y.place(point.y))};
  };
  std::vector<Area> taken;
  for (const Series& series : panel.series) {
    for (const Point& point : series.points) {
      if (!series.marks || !scales.take(point)) continue;
      const auto [x, y] = at(point);
      taken.push_back({x - mark / 2.0, y - mark / 2.0, mark, mark});
    }
  }
  std::vector<PlacedLabel> labels;
  for (const Series& series : panel.series) {
    for (const Point& point : series.points) {
      if (point.label.empty() || !scales.take(point)) continue;
      const auto [x, y] = at(point);
      const double width = letter * static_cast<double>(text_width(point.label));
      const std::vector<Area> places = places_round(x, y, width);
      const auto free = std::ranges::find_if(places, [&](const Area& place) {
        return area.holds(place) &&
               std::ranges::none_of(taken, [&](const Area& other) { return other.meets(place); });
      });
      if (free == places.end()) continue;
      taken.push_back(*free);
      constexpr std::ptrdiff_t beside = 4;
      labels.push_back({point.label, *free, free - places.begin() >= beside, x, y});
    }
  }
  return labels;
}

}  // namespace hsr::report
