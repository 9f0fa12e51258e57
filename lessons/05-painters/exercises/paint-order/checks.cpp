// Each case is a list of triangles, told by the depths of their corners.

struct OrderCase {
  const char* name;
  std::vector<Triangle> triangles;
  std::vector<double> want;
};

/// A triangle of which only depths matter, in the middle of the picture.
Triangle at_depths(double a, double b, double c) { return {{{0, 0, a}, {0.01, 0, b}, {0, 0.01, c}}}; }

template <class CheckOfFunction>
void checks(CheckOfFunction& check) {
  std::vector<Triangle> many;
  std::vector<double> many_wanted;
  for (int k = 0; k < 40; ++k) {  // enough that std::sort is not stable
    many.push_back(at_depths(7, 7, 5));
    many_wanted.push_back(k);
  }
  const OrderCase cases[] = {
      {"three, the farthest last", {at_depths(2, 2, 2), at_depths(4, 4, 4), at_depths(6, 6, 6)}, {2, 1, 0}},
      {"three, mixed", {at_depths(4, 4, 4), at_depths(6, 6, 6), at_depths(2, 2, 2)}, {1, 0, 2}},
      {"four, mixed",
       {at_depths(3, 3, 3), at_depths(9, 9, 9), at_depths(5, 5, 5), at_depths(7, 7, 7)},
       {1, 3, 2, 0}},
      {"a floor that reaches far, and a wall", {at_depths(2, 2, 16), at_depths(7, 7, 7)}, {0, 1}},
      {"the farthest corner is the first", {at_depths(8, 8, 8), at_depths(9, 2, 2)}, {1, 0}},
      {"the farthest corner is the second", {at_depths(8, 8, 8), at_depths(2, 9, 2)}, {1, 0}},
      {"the farthest corner is the third", {at_depths(8, 8, 8), at_depths(2, 2, 9)}, {1, 0}},
      {"near and far corners disagree",
       {at_depths(3, 3, 10), at_depths(1, 11, 1), at_depths(6, 6, 9)},
       {1, 0, 2}},
      {"one near corner, two far ones", {at_depths(1, 10, 10), at_depths(5, 5, 6)}, {0, 1}},
      {"far to the side is not deep", {{{{30, 0, 5}, {31, 0, 5}, {30, 1, 5}}}, at_depths(8, 8, 8)}, {1, 0}},
      {"equal keys", {at_depths(5, 5, 5), at_depths(2, 3, 5), at_depths(5, 1, 1)}, {0, 1, 2}},
      {"forty with equal keys", many, many_wanted},
      {"one", {at_depths(5, 5, 5)}, {0}},
  };
  for (const OrderCase& each : cases) {
    std::string input;
    for (std::size_t k = 0; k < each.triangles.size() && k < 5; ++k) {
      const Point* corners = each.triangles[k].corners;
      input += (k == 0 ? "corners at depths " : ", ") +
               check::in_brackets({corners[0].z, corners[1].z, corners[2].z});
    }
    check.view = "scene big-and-small\npicture 640 360\nalgorithm painter\npixel 220 307";
    check.run(
        each.name, each.triangles.size() > 5 ? input + " ..." : input,
        [&](auto function) {
          check::Answer answer;
          for (const int place : function(each.triangles)) answer.numbers.push_back(place);
          answer.text = "order " + check::in_brackets(answer.numbers);
          return answer;
        },
        check::Answer{each.want, "order " + check::in_brackets(each.want), 0});
  }
}
