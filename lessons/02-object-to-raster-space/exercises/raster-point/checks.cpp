// Each case is a point, a canvas and a picture, with the pixel worked out by hand.

struct PointCase {
  const char* name;
  Point p;
  Canvas canvas;
  int width;
  int height;
  Pixel want;
};

template <class CheckOfFunction>
void checks(CheckOfFunction& check) {
  const Canvas wide = {32.0 / 9.0, 2.0};  // of a field of view of 90 degrees at 64 by 36 pixels
  const PointCase cases[] = {
      {"the example of lesson 2", {-1, 2, 10}, {2, 2}, 64, 64, {28, 25}},
      {"the corner of the box of lesson 2", {1.5, 0.9, 4}, wide, 64, 36, {38, 13}},
      {"a point in the middle", {0, 0, 5}, {2, 2}, 64, 64, {32, 32}},
      {"a point in the upper left pixel", {-3.99, 3.99, 4}, {2, 2}, 64, 64, {0, 0}},
      {"the upper left corner of the canvas", {-2, 2, 2}, {2, 2}, 64, 64, {0, 0}},
      {"a point far to the side, and far away", {60, -45, 100}, {2, 2}, 64, 48, {51, 34}},
      {"a point close to the eye", {0.125, 0.0625, 0.25}, {2, 2}, 64, 64, {48, 24}},
      {"the lower right corner of the canvas", {4, -4, 4}, {2, 2}, 64, 48, {63, 47}},
      {"on the right border", {3, 0.3, 3}, {2, 2}, 64, 64, {63, 28}},
      {"a little to the left of the picture", {-1.01, 0, 1}, {2, 2}, 64, 64, {-1, 32}},
      {"a little above the picture", {0, 1.02, 1}, {2, 2}, 64, 64, {32, -1}},
      {"to the right of the picture", {1.1, 0, 1}, {2, 2}, 64, 64, {67, 32}},
      {"a picture of one pixel", {0.3, -0.7, 1}, {2, 2}, 1, 1, {0, 0}},
  };
  for (const PointCase& each : cases) {
    const Point p = each.p;
    // The scene box from where its corner is the second case.
    check.view = "scene box\npicture 64 36\ncamera 0,0,5 0,0,0 0,1,0 90\nalgorithm zbuffer\npixel 38 14";
    check.run(
        each.name,
        "p = " + check::in_brackets({p.x, p.y, p.z}) + ", canvas " + check::shown(each.canvas.width) +
            " by " + check::shown(each.canvas.height) + ", picture " + check::shown(each.width) + " by " +
            check::shown(each.height),
        [&](auto function) {
          const Pixel pixel = function(p, each.canvas, each.width, each.height);
          return check::answer({double(pixel.i), double(pixel.j)});
        },
        check::answer({double(each.want.i), double(each.want.j)}));
  }
}
