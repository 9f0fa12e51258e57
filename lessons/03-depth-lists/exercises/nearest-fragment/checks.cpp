// Each case is a list, with the place that is wanted.

struct ListCase {
  const char* name;
  std::vector<Fragment> list;
  int want;
};

template <class CheckOfFunction>
void checks(CheckOfFunction& check) {
  const ListCase cases[] = {
      {"three surfaces of crossing, as they come", {{0, 5.0244}, {1, 5.0259}, {2, 5.3035}}, 0},
      {"the same, the other way round", {{7, 5.3035}, {4, 5.0259}, {3, 5.0244}}, 2},
      {"the nearest in the middle", {{5, 12.0}, {9, 3.5}, {2, 8.0}, {6, 100.0}}, 1},
      {"close together, the nearest with a higher id", {{9, 5.3}, {4, 5.0244}, {1, 5.0259}}, 1},
      {"one fragment", {{3, 42.0}}, 0},
      {"nothing at all", {}, -1},
      {"very near", {{8, 0.9}, {3, 0.25}, {5, 0.5}}, 1},
      {"very far", {{8, 3e6}, {6, 2e6}, {7, 2.5e6}}, 1},
      {"a tie, the lower id first", {{2, 4.0}, {9, 4.0}, {1, 6.0}}, 0},
      {"a tie, the lower id last", {{9, 4.0}, {5, 6.0}, {2, 4.0}}, 2},
      {"a tie of three", {{7, 4.0}, {1, 4.0}, {3, 4.0}}, 1},
      {"a tie behind the nearest", {{4, 5.0}, {2, 5.0}, {8, 1.5}}, 2},
  };
  for (const ListCase& each : cases) {
    std::string input = "list:";
    for (const Fragment& fragment : each.list)
      input += " {id " + std::to_string(fragment.id) + ", depth " + check::shown(fragment.depth) + "}";
    check.view = "scene crossing\npicture 640 360\nalgorithm depthlist\npixel 300 180";
    check.run(
        each.name, each.list.empty() ? "an empty list" : input,
        [&](auto function) { return check::answer({double(function(each.list))}); },
        check::answer({double(each.want)}));
  }
}
