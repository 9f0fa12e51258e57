// Each case is a pair of triangles.

struct PairCase {
  const char* name;
  Triangle p;
  Triangle q;
  bool want;
};

std::string corners_text(const Triangle& triangle) {
  std::string text;
  for (const Point& p : triangle.corners)
    text += (text.empty() ? "" : " ") + check::in_brackets({p.x, p.y, p.z});
  return text;
}

template <class CheckOfFunction>
void checks(CheckOfFunction& check) {
  const Triangle wall = {{{-2, -2, 5}, {2, -2, 5}, {0, 2, 5}}};
  const Triangle wall_turned = {{{-2, -2, 5}, {0, 2, 5}, {2, -2, 5}}};
  const Triangle slope = {{{-4, -4, 4}, {4, -4, 4}, {0, 4, 12}}};  // z = y + 8
  const Triangle slope_turned = {{{-4, -4, 4}, {0, 4, 12}, {4, -4, 4}}};
  const PairCase cases[] = {
      {"all behind a wall", {{{0, 0, 7}, {1, 0, 8}, {0, 1, 9}}}, wall, true},
      {"all before a wall", {{{0, 0, 2}, {1, 0, 3}, {0, 1, 4}}}, wall, false},
      {"behind a wall whose corners come the other way",
       {{{0, 0, 7}, {1, 0, 8}, {0, 1, 9}}},
       wall_turned,
       true},
      {"before that wall", {{{0, 0, 2}, {1, 0, 3}, {0, 1, 4}}}, wall_turned, false},
      {"the last corner before it", {{{0, 0, 7}, {1, 0, 8}, {0, 1, 4}}}, wall, false},
      {"the first corner before it", {{{0, 0, 4}, {1, 0, 8}, {0, 1, 9}}}, wall, false},
      {"two corners before it", {{{0, 0, 4}, {1, 0, 8}, {0, 1, 4}}}, wall, false},
      {"an edge in the plane, the rest behind", {{{0, 0, 5}, {1, 0, 5}, {0, 1, 9}}}, wall, true},
      {"an edge in the plane, the rest before", {{{0, 0, 5}, {1, 0, 5}, {0, 1, 4}}}, wall, false},
      {"wholly in the plane", {{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}}}, wall, true},
      {"wholly in the plane, turned", {{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}}}, wall_turned, true},
      {"behind a slope, and nearer than its far end", {{{0, -3, 6}, {1, -3, 6}, {0, -2, 7}}}, slope, true},
      {"before a slope, and farther than its near end", {{{0, 3, 9}, {1, 3, 9}, {0, 2, 8}}}, slope, false},
      {"behind a slope, turned", {{{0, -3, 6}, {1, -3, 6}, {0, -2, 7}}}, slope_turned, true},
      {"through a slope; all of the slope on one side of it",
       {{{0, 3, 10}, {9, 3, 12}, {0, 3, 14}}},
       slope,
       false},
      {"high above, before a slope", {{{0, 9, 4}, {1, 9, 4}, {0, 9, 5}}}, slope, false},
      {"a slope and a wall behind its near part", {{{-2, -4, 5}, {2, -4, 5}, {0, -3, 5}}}, slope, true},
  };
  for (const PairCase& each : cases) {
    check.view = "scene three-bars\npicture 640 360\nalgorithm newell\npixel 320 180";
    check.run(
        each.name, "P " + corners_text(each.p) + "; Q " + corners_text(each.q),
        [&](auto function) {
          const bool behind = function(each.p, each.q);
          return check::Answer{{behind ? 1.0 : 0.0}, behind ? "behind" : "not behind", 0};
        },
        check::Answer{{each.want ? 1.0 : 0.0}, each.want ? "behind" : "not behind", 0});
  }
}
