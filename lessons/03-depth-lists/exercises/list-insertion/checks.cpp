// Each case is a sorted list and a fragment, with the ids that are wanted, in order.

struct InsertionCase {
  const char* name;
  std::vector<Fragment> list;
  Fragment fragment;
  std::vector<double> want;
};

std::string list_text(const std::vector<Fragment>& list) {
  std::string text;
  for (const Fragment& fragment : list) {
    text += (text.empty() ? "" : ", ") + ("id " + std::to_string(fragment.id)) + " at depth " +
            check::shown(fragment.depth);
  }
  return text.empty() ? "an empty list" : text;
}

template <class CheckOfFunction>
void checks(CheckOfFunction& check) {
  const InsertionCase cases[] = {
      {"in the middle", {{0, 2.0}, {1, 4.0}, {2, 6.0}}, {3, 3.0}, {0, 3, 1, 2}},
      {"before all others", {{5, 2.0}, {1, 4.0}}, {3, 1.0}, {3, 5, 1}},
      {"behind all others", {{5, 2.0}, {1, 4.0}}, {3, 9.0}, {5, 1, 3}},
      {"the first of all", {}, {7, 4.0}, {7}},
      {"before a single one", {{5, 2.0}}, {8, 1.5}, {8, 5}},
      {"a tie with a lower id", {{2, 2.0}, {4, 4.0}, {6, 6.0}}, {3, 4.0}, {2, 3, 4, 6}},
      {"a tie with a higher id", {{2, 2.0}, {4, 4.0}, {6, 6.0}}, {5, 4.0}, {2, 4, 5, 6}},
      {"a tie between two", {{1, 4.0}, {8, 4.0}, {9, 4.0}}, {5, 4.0}, {1, 5, 8, 9}},
      {"close together", {{1, 5.0244}, {2, 5.3035}}, {0, 5.0259}, {1, 0, 2}},
  };
  for (const InsertionCase& each : cases) {
    check.view = "scene layers:6\npicture 640 360\nalgorithm depthlist\npixel 320 180";
    check.run(
        each.name, list_text(each.list) + "; to be inserted: " + list_text({each.fragment}),
        [&](auto function) {
          std::vector<Fragment> list = each.list;
          function(list, each.fragment);
          check::Answer answer;
          for (const Fragment& fragment : list) answer.numbers.push_back(fragment.id);
          answer.text = list_text(list);
          return answer;
        },
        check::Answer{each.want, "ids " + check::in_brackets(each.want), 0});
  }
}
