// Each case is a depth between two planes.

struct StoredCase {
  const char* name;
  double w;
  double near_depth;
  double far_depth;
};

template <class CheckOfFunction>
void checks(CheckOfFunction& check) {
  const StoredCase cases[] = {
      {"at the near plane", 1, 1, 10},
      {"at the far plane", 10, 1, 10},
      {"half-way between the planes", 5.5, 1, 10},
      {"at twice near", 2, 1, 10},
      {"one board of hair-apart", 4.9, 2.72, 6.2},
      {"a patch above it", 4.89998, 2.72, 6.2},
      {"far away, with near very near", 500, 0.01, 1000},
      {"close to far", 9.99, 1, 10},
      {"nearer than near", 0.5, 1, 10},
      {"farther than far", 12, 1, 10},
      {"planes close together", 100.5, 100, 101},
      {"large planes", 40000, 1000, 100000},
  };
  for (const StoredCase& each : cases) {
    check.view = "scene hair-apart\npicture 640 360\nalgorithm zbuffer[depth=unorm16]\npixel 400 180";
    check.run(each.name,
              "w = " + check::shown(each.w) + ", near " + check::shown(each.near_depth) + ", far " +
                  check::shown(each.far_depth),
              [&](auto function) {
                return check::answer({double(function(each.w, each.near_depth, each.far_depth))});
              });
  }
}
