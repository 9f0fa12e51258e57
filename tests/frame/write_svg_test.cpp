#include "frame/write_svg.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "algorithm.h"
#include "scene/catalog.h"
#include "support/temporary_folder.h"

namespace {

struct Polygon {
  std::vector<std::uint32_t> triangles;
  std::vector<glm::dvec2> corners;
};

/// What stands in quotation marks after `name=` in a line, or nothing.
std::string attribute(const std::string& line, const std::string& name) {
  const std::size_t found = line.find(" " + name + "=\"");
  if (found == std::string::npos) return {};
  const std::size_t begin = found + name.size() + 3;
  return line.substr(begin, line.find('"', begin) - begin);
}

/// Reads the polygons back from the text of the file, with nothing of what wrote it.
std::vector<Polygon> polygons_in(const std::string& svg) {
  std::vector<Polygon> polygons;
  std::istringstream lines(svg);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("<polygon ")) continue;
    Polygon polygon;
    std::istringstream ids(attribute(line, "data-triangles"));
    for (std::uint32_t id = 0; ids >> id;) polygon.triangles.push_back(id);
    std::istringstream points(attribute(line, "points"));
    char comma = 0;
    for (glm::dvec2 corner; points >> corner.x >> comma >> corner.y;) polygon.corners.push_back(corner);
    polygons.push_back(polygon);
  }
  return polygons;
}

/// Whether a point lies inside by more than `margin`, or outside by more; nothing where neither holds.
std::optional<bool> is_inside(const Polygon& polygon, const glm::dvec2& point, double margin) {
  bool inside = false;
  double nearest = 1e300;
  for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
    const glm::dvec2 from = polygon.corners[k];
    const glm::dvec2 to = polygon.corners[(k + 1) % polygon.corners.size()];
    if ((from.y > point.y) != (to.y > point.y) &&
        point.x < from.x + (point.y - from.y) / (to.y - from.y) * (to.x - from.x)) {
      inside = !inside;
    }
    const glm::dvec2 way = to - from;
    const double length = way.x * way.x + way.y * way.y;
    const double part =
        length > 0.0
            ? std::fmin(1.0,
                        std::fmax(0.0, ((point.x - from.x) * way.x + (point.y - from.y) * way.y) / length))
            : 0.0;
    nearest =
        std::fmin(nearest, std::hypot(point.x - from.x - part * way.x, point.y - from.y - part * way.y));
  }
  if (nearest < margin) return std::nullopt;
  return inside;
}

/// Counts the pixels whose centres lie clear of every edge, and those of them where the polygon painted
/// last there is not what the frame shows.
struct Compared {
  int clear = 0;
  int different = 0;
};

Compared compare(const std::vector<Polygon>& polygons, const hsr::Frame& frame) {
  Compared compared;
  for (int j = 0; j < frame.height; ++j) {
    for (int i = 0; i < frame.width; ++i) {
      const Polygon* last = nullptr;
      bool clear = true;
      for (const Polygon& polygon : polygons) {
        const std::optional<bool> inside = is_inside(polygon, {i + 0.5, j + 0.5}, 0.01);
        if (!inside) clear = false;
        if (inside.value_or(false)) last = &polygon;
      }
      if (!clear) continue;
      ++compared.clear;
      const std::uint32_t shown = frame.id[frame.index(i, j)];
      const bool same = last == nullptr ? shown == hsr::background_id
                                        : std::ranges::find(last->triangles, shown) != last->triangles.end();
      if (!same) ++compared.different;
    }
  }
  return compared;
}

}  // namespace

TEST_CASE("frame: vector graphics rasterized by themselves show what the picture shows") {
  const hsr::test::TemporaryFolder folder;
  for (const char* name : {"three-bars", "crossing", "box", "needles", "room", "cube"}) {
    const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(name);
    REQUIRE(scene);
    const hsr::View view = hsr::make_view(*scene, *scene->camera, 48, 36);
    for (const char* algorithm : {"painter", "newell"}) {
      CAPTURE(name);
      CAPTURE(algorithm);
      const hsr::AlgorithmSpec spec = hsr::parse_algorithm_spec(algorithm);
      hsr::Frame frame(view.width, view.height);
      frame.faces.emplace();
      spec.algorithm->prepare(*scene, spec.settings, {})->render(view, {}, frame);
      REQUIRE(frame.faces);
      const auto file = folder.path() / "faces.svg";
      hsr::write_svg(*frame.faces, view.width, view.height, glm::vec3(1.0F), file);
      const std::vector<Polygon> polygons = polygons_in(hsr::test::content_of(file));
      CHECK(polygons.size() == frame.faces->size());
      const Compared compared = compare(polygons, frame);
      CHECK(compared.clear > 500);
      CHECK(compared.different == 0);
    }
  }
}

TEST_CASE("frame: a face of the vector graphics has its triangles, its colour in sRGB and its opacity") {
  const hsr::test::TemporaryFolder folder;
  const auto file = folder.path() / "one.svg";
  hsr::PaintedFace face;
  face.triangles = {7, 8};
  face.piece = 2;
  face.color = glm::vec4(0.5F, 0.0F, 0.0F, 0.5F);  // premultiplied: pure red
  face.outline = {{0.0, 0.5}, {10.25, 0.5}, {3.0, 7.0}};
  hsr::write_svg({face}, 16, 9, glm::vec3(1.0F), file);
  const std::string svg = hsr::test::content_of(file);
  CHECK(svg.find("<polygon id=\"t7-2\" data-triangles=\"7 8\" fill=\"#ff0000\" fill-opacity=\"0.5\" "
                 "points=\"0.000000,0.500000 10.250000,0.500000 3.000000,7.000000\"/>") != std::string::npos);
  CHECK(svg.find("width=\"16\" height=\"9\"") != std::string::npos);
}
