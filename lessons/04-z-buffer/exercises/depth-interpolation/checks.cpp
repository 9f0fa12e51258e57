// Each case is a triangle and a pixel that it covers.

struct DepthCase {
  const char* name;
  Triangle triangle;
  int i;
  int j;
};

std::string corner_text(const Corner& corner) {
  return check::in_brackets({corner.x, corner.y}) + " at depth " + check::shown(corner.depth);
}

template <class CheckOfFunction>
void checks(CheckOfFunction& check) {
  const Triangle road = {{0, 20, 1}, {40, 20, 1}, {20, 0, 100}};
  const DepthCase cases[] = {
      {"squarely before the eye", {{0, 0, 5}, {40, 0, 5}, {0, 20, 5}}, 10, 5},
      {"a road, half-way up the picture", road, 19, 9},
      {"a road, close by", road, 5, 18},
      {"a road, far away", road, 19, 1},
      {"three depths", {{2, 1, 2}, {37, 4, 8}, {9, 18, 3}}, 12, 6},
      {"the same, the corners in the other order", {{2, 1, 2}, {9, 18, 3}, {37, 4, 8}}, 12, 6},
      {"at the first corner", {{4.5, 2.5, 3}, {30, 5, 9}, {8, 17, 6}}, 4, 2},
      {"at the second corner", {{30, 5, 9}, {4.5, 2.5, 3}, {8, 17, 6}}, 4, 2},
      {"at the third corner", {{30, 5, 9}, {8, 17, 6}, {4.5, 2.5, 3}}, 4, 2},
      {"in the middle of an edge", {{4.5, 2.5, 2}, {20.5, 2.5, 6}, {8, 17, 4}}, 12, 2},
      {"a hair apart", {{0, 0, 5.0244}, {40, 3, 5.0259}, {7, 20, 5.0251}}, 15, 7},
  };
  check.tolerance = 1e-9;
  for (const DepthCase& each : cases) {
    const Triangle& t = each.triangle;
    check.view = "scene crossing\npicture 640 360\nalgorithm zbuffer\npixel 300 180";
    check.run(each.name,
              "corners " + corner_text(t.a) + ", " + corner_text(t.b) + ", " + corner_text(t.c) + "; pixel " +
                  check::in_brackets({double(each.i), double(each.j)}),
              [&](auto function) { return check::answer({function(t, each.i, each.j)}); });
  }
}
