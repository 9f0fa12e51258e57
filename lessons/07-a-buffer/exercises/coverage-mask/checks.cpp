// Each case is a triangle and a pixel; the mask is shown as a picture of 4 by 4 samples.

struct MaskCase {
  const char* name;
  Triangle triangle;
  int i;
  int j;
};

template <class CheckOfFunction>
void checks(CheckOfFunction& check) {
  const MaskCase cases[] = {
      {"all of the pixel", {{-10, -10}, {40, -10}, {-10, 40}}, 3, 2},
      {"none of it", {{0, 0}, {2, 0}, {0, 1}}, 3, 2},
      {"the upper half", {{-10, -8}, {30, -8}, {10, 2.5}}, 10, 2},
      {"the left half", {{-20, 2}, {3.5, -20}, {3.5, 30}}, 3, 2},
      {"the upper left", {{3, 2}, {4, 2}, {3, 2.75}}, 3, 2},
      {"the same, its corners in the other order", {{3, 2}, {3, 2.75}, {4, 2}}, 3, 2},
      {"an edge through samples", {{3.125, 2.125}, {3.875, 2.125}, {3.875, 2.875}}, 3, 2},
      {"its neighbour across that edge", {{3.125, 2.125}, {3.125, 2.875}, {3.875, 2.875}}, 3, 2},
      {"a corner in one sample", {{3.625, 2.375}, {6, 0}, {6, 1}}, 3, 2},
      {"smaller than a pixel, and not at its centre", {{3, 2}, {3.375, 2}, {3, 2.5}}, 3, 2},
      {"a sliver in one column", {{3.25, 1}, {3.5, 1}, {3.375, 9}}, 3, 2},
      {"without area, through samples", {{3.125, 2.125}, {3.875, 2.875}, {3.5, 2.5}}, 3, 2},
      {"another pixel", {{0, 0}, {7.375, 0}, {0, 9}}, 4, 3},
  };
  for (const MaskCase& each : cases) {
    const Triangle& t = each.triangle;
    check.view = "scene crossing\npicture 320 180\nalgorithm abuffer\npixel 179 83";
    check.run(each.name,
              "triangle " + check::in_brackets({t.a.x, t.a.y}) + " " + check::in_brackets({t.b.x, t.b.y}) +
                  " " + check::in_brackets({t.c.x, t.c.y}) + ", pixel " +
                  check::in_brackets({double(each.i), double(each.j)}),
              [&](auto function) {
                const unsigned mask = function(t, each.i, each.j);
                std::vector<double> samples;
                for (int bit = 0; bit < 16; ++bit) samples.push_back(((mask >> bit) & 1U) != 0 ? 1.0 : -1.0);
                return check::picture(4, samples);
              });
  }
}
