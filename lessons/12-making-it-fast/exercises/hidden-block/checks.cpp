// Each case is a triangle and a block.

struct BlockCase {
  const char* name;
  Triangle triangle;
  double block[4];  ///< four times in a row
  bool want;
};

template <class CheckOfFunction>
void checks(CheckOfFunction& check) {
  const double nothing = std::numeric_limits<double>::infinity();
  const BlockCase cases[] = {
      {"behind all of a wall", {{8, 9, 10}}, {3, 3, 3, 3}, true},
      {"before a wall", {{1, 2, 2.5}}, {3, 3, 3, 3}, false},
      {"behind a slope", {{8, 9, 7}}, {3, 4, 5, 6}, true},
      {"behind the near part of a slope only", {{4.5, 5, 5.5}}, {3, 4, 5, 6}, false},
      {"through a wall: one corner before it", {{2, 9, 10}}, {3, 3, 3, 3}, false},
      {"one corner behind it, two before", {{2, 2.5, 10}}, {3, 3, 3, 3}, false},
      {"the second corner is the nearest", {{9, 2, 8}}, {3, 3, 3, 3}, false},
      {"the third corner is the nearest", {{9, 8, 2}}, {3, 3, 3, 3}, false},
      {"an empty block", {{8, 9, 10}}, {nothing, nothing, nothing, nothing}, false},
      {"one column shows the background", {{8, 9, 10}}, {3, 3, nothing, 3}, false},
      {"the last column shows the background", {{8, 9, 10}}, {3, 3, 3, nothing}, false},
      {"equally deep as the farthest pixel", {{6, 7, 8}}, {3, 4, 5, 6}, false},
      {"a hair behind the farthest pixel", {{6.000001, 7, 8}}, {3, 4, 5, 6}, true},
      {"behind the mean, before the farthest", {{5, 6, 7}}, {3, 3, 3, 6}, false},
      {"far away", {{2e6, 3e6, 4e6}}, {1e6, 1.5e6, 1e6, 1e6}, true},
  };
  for (const BlockCase& each : cases) {
    Block block;
    for (int k = 0; k < 16; ++k) block.depth[k] = each.block[k % 4];
    const Triangle& t = each.triangle;
    check.view = "scene behind-a-wall:8\npicture 160 90\nalgorithm zbuffer-fast\npixel 80 45";
    check.run(
        each.name,
        "corners at depths " + check::in_brackets({t.depth[0], t.depth[1], t.depth[2]}) +
            ", each row of the block shows " +
            check::in_brackets({each.block[0], each.block[1], each.block[2], each.block[3]}),
        [&](auto function) {
          const bool hidden = function(t, block);
          return check::Answer{{hidden ? 1.0 : 0.0}, hidden ? "hidden" : "not hidden for certain", 0};
        },
        check::Answer{{each.want ? 1.0 : 0.0}, each.want ? "hidden" : "not hidden for certain", 0});
  }
}
