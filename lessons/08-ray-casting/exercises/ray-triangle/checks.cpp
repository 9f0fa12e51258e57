// Each case is a ray and a triangle, with the t that is wanted. A miss is compared as a very small number,
// which no t is.

struct RayCase {
  const char* name;
  Ray ray;
  Triangle triangle;
  double want;
};

std::string vector_text(const Vector& v) { return check::in_brackets({v.x, v.y, v.z}); }

check::Answer hit_answer(double t) {
  if (t == std::numeric_limits<double>::infinity()) return {{-1e300}, "a miss", 0};
  return {{t}, "t = " + check::shown(t), 0};
}

template <class CheckOfFunction>
void checks(CheckOfFunction& check) {
  const double miss = std::numeric_limits<double>::infinity();
  const Triangle wall = {{0, 0, 8}, {8, 0, 8}, {0, 8, 8}};
  const Triangle turned = {{0, 0, 8}, {0, 8, 8}, {8, 0, 8}};
  const Triangle slope = {{-4, -4, 4}, {4, -4, 4}, {0, 4, 12}};
  const RayCase cases[] = {
      {"the middle of a wall", {{2, 2, 0}, {0, 0, 1}}, wall, 8},
      {"the same from its other side", {{2, 2, 0}, {0, 0, 1}}, turned, 8},
      {"a slanting ray", {{0, 0, 0}, {0.25, 0.375, 1}}, wall, 8},
      {"a slope", {{0, 0, 0}, {0, -0.25, 1}}, slope, 6.4},
      {"a direction of length 4", {{2, 2, 0}, {0, 0, 4}}, wall, 2},
      {"beyond the long edge", {{6, 6, 0}, {0, 0, 1}}, wall, miss},
      {"beside it, u below 0", {{-1, 2, 0}, {0, 0, 1}}, wall, miss},
      {"beside it, v below 0", {{2, -1, 0}, {0, 0, 1}}, wall, miss},
      {"above it", {{1, 9, 0}, {0, 0, 1}}, wall, miss},
      {"behind the origin", {{2, 2, 10}, {0, 0, 1}}, wall, miss},
      {"away from it", {{2, 2, 0}, {0, 0, -1}}, wall, miss},
      {"through the edge from a to b", {{4, 0, 0}, {0, 0, 1}}, wall, 8},
      {"through the edge from a to c", {{0, 4, 0}, {0, 0, 1}}, wall, 8},
      {"through the long edge", {{4, 4, 0}, {0, 0, 1}}, wall, 8},
      {"through a corner", {{0, 0, 0}, {0, 0, 1}}, wall, 8},
      {"along its plane, beside it", {{1, 1, 6}, {1, 0, 0}}, wall, miss},
      {"along its plane, in it", {{-3, 1, 8}, {1, 0, 0}}, wall, miss},
      {"a triangle without area", {{2, 2, 0}, {0, 0, 1}}, {{0, 0, 8}, {2, 2, 8}, {4, 4, 8}}, miss},
      {"a very small triangle",
       {{0.0000152587890625, 0.0000152587890625, 0}, {0, 0, 1}},
       {{0, 0, 8}, {0.00006103515625, 0, 8}, {0, 0.00006103515625, 8}},
       8},
      {"the same with its corners in the other order",
       {{0.0000152587890625, 0.0000152587890625, 0}, {0, 0, 1}},
       {{0, 0, 8}, {0, 0.00006103515625, 8}, {0.00006103515625, 0, 8}},
       8},
  };
  check.tolerance = 1e-12;
  for (const RayCase& each : cases) {
    check.view = "scene crossing\npicture 320 180\nalgorithm raycast\npixel 179 83";
    check.run(
        each.name,
        "ray from " + vector_text(each.ray.origin) + " along " + vector_text(each.ray.direction) +
            ", triangle " + vector_text(each.triangle.a) + " " + vector_text(each.triangle.b) + " " +
            vector_text(each.triangle.c),
        [&](auto function) { return hit_answer(function(each.ray, each.triangle)); }, hit_answer(each.want));
  }
}
