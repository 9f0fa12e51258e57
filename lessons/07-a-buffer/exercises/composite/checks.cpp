// Each case is a list.

struct BlendCase {
  const char* name;
  std::vector<Fragment> list;
};

template <class CheckOfFunction>
void checks(CheckOfFunction& check) {
  const Fragment red = {0.5, 0, 0, 0.5};
  const Fragment green = {0, 0.5, 0, 0.5};
  const Fragment blue = {0, 0, 0.2, 0.25};
  const Fragment wall = {0.8, 0.7, 0.6, 1.0};
  const Fragment clear = {0, 0, 0, 0};
  const BlendCase cases[] = {
      {"one opaque surface", {wall}},
      {"a pane alone", {red}},
      {"a pane before a wall", {green, wall}},
      {"two panes", {red, green}},
      {"three panes", {red, green, blue}},
      {"three panes before a wall", {blue, red, green, wall}},
      {"panes behind a wall", {wall, red, green}},
      {"a wall between panes", {blue, wall, red}},
      {"a surface that lets everything through", {clear, red, wall}},
      {"six panes of opacity 0.3", std::vector<Fragment>(6, {0.3, 0.15, 0.06, 0.3})},
      {"nothing at all", {}},
  };
  check.tolerance = 1e-12;
  for (const BlendCase& each : cases) {
    std::string input;
    for (const Fragment& f : each.list) input += check::in_brackets({f.r, f.g, f.b, f.opacity}) + " ";
    check.view = "scene layers:6\npicture 640 360\nalgorithm abuffer\npixel 320 180";
    check.run(each.name, each.list.empty() ? "an empty list" : "r, g, b, opacity: " + input,
              [&](auto function) {
                const Color color = function(each.list);
                return check::answer({color.r, color.g, color.b, color.opacity});
              });
  }
}
