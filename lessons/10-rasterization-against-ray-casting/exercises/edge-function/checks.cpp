// Each case is a picture of 16 by 10 pixels of some triangles. A pixel shows the lowest number of those that
// cover it.

struct TrianglesCase {
  const char* name;
  std::vector<Triangle> triangles;
};

std::string triangles_text(const std::vector<Triangle>& triangles) {
  std::string text;
  for (const Triangle& t : triangles) {
    text += (text.empty() ? "triangle " : ", triangle ") + check::in_brackets({t.a.x, t.a.y}) + " " +
            check::in_brackets({t.b.x, t.b.y}) + " " + check::in_brackets({t.c.x, t.c.y});
  }
  return text;
}

template <class CheckOfFunction>
void checks(CheckOfFunction& check) {
  const TrianglesCase cases[] = {
      {"a triangle", {{{1.25, 1.125}, {14.75, 4.25}, {3.125, 9.375}}}},
      {"the same with its corners in the other order", {{{1.25, 1.125}, {3.125, 9.375}, {14.75, 4.25}}}},
      {"corners at centres of pixels", {{{2.5, 1.5}, {12.5, 1.5}, {2.5, 8.5}}}},
      {"two that share an edge through centres",
       {{{1.5, 1.5}, {9.5, 1.5}, {9.5, 9.5}}, {{1.5, 1.5}, {1.5, 9.5}, {9.5, 9.5}}}},
      {"four round a centre",
       {{{8.5, 5.5}, {2.0, 1.0}, {15.0, 1.0}},
        {{8.5, 5.5}, {15.0, 1.0}, {15.0, 9.0}},
        {{8.5, 5.5}, {15.0, 9.0}, {2.0, 9.0}},
        {{8.5, 5.5}, {2.0, 9.0}, {2.0, 1.0}}}},
      {"a large one, of which a part is seen", {{{-20.0, 4.0}, {30.0, -30.0}, {12.0, 40.0}}}},
      {"thin, between the rows", {{{1.0, 3.625}, {15.0, 3.75}, {1.0, 4.375}}}},
      {"thin, along the centres of a row", {{{1.0, 3.5}, {15.0, 3.5}, {8.0, 4.375}}}},
      {"without area, through centres", {{{1.5, 1.5}, {5.5, 5.5}, {8.5, 8.5}}}},
      {"a single point", {{{4.5, 4.5}, {4.5, 4.5}, {4.5, 4.5}}}},
  };
  for (const TrianglesCase& each : cases) {
    check.view = "scene aligned-grid:4:8:36\npicture 72 36\nalgorithm zbuffer\npixel 36 17";
    check.run(each.name, triangles_text(each.triangles), [&](auto function) {
      constexpr int width = 16;
      constexpr int height = 10;
      std::vector<double> shown(width * height, -1.0);
      for (int pixel = 0; pixel < width * height; ++pixel) {
        for (int k = static_cast<int>(each.triangles.size()) - 1; k >= 0; --k) {
          if (function(each.triangles[static_cast<std::size_t>(k)], pixel % width, pixel / width))
            shown[static_cast<std::size_t>(pixel)] = k;
        }
      }
      return check::picture(width, shown);
    });
  }
}
