#include "scene/built_in/entries.h"
#include "scene/built_in/mesh_builder.h"
#include "scene/built_in/okabe_ito.h"
#include "scene/built_in/teapot.h"

namespace hsr::built_in {
namespace {

// The room reaches from -3 to 3 in x, from 0 to 2.75 in y and from -4 to 4 in z; units are metres.
constexpr glm::dvec3 least{-3.0, 0.0, -4.0};
constexpr glm::dvec3 greatest{3.0, 2.75, 4.0};

void add_walls(MeshBuilder& builder) {
  const double width = greatest.x - least.x;
  const double height = greatest.y - least.y;
  const double depth = greatest.z - least.z;
  builder.material("floor", 0xA08060);
  builder.parallelogram({least.x, least.y, greatest.z}, {width, 0.0, 0.0}, {0.0, 0.0, -depth});
  builder.material("ceiling", okabe_ito::white);
  builder.parallelogram({least.x, greatest.y, least.z}, {width, 0.0, 0.0}, {0.0, 0.0, depth});
  builder.material("wall", 0xE6DCC8);
  builder.parallelogram(least, {width, 0.0, 0.0}, {0.0, height, 0.0});
  builder.parallelogram({greatest.x, least.y, greatest.z}, {-width, 0.0, 0.0}, {0.0, height, 0.0});
  builder.parallelogram({least.x, least.y, greatest.z}, {0.0, 0.0, -depth}, {0.0, height, 0.0});
  builder.parallelogram({greatest.x, least.y, least.z}, {0.0, 0.0, depth}, {0.0, height, 0.0});
}

void add_table(MeshBuilder& builder) {
  builder.material("table", okabe_ito::orange);
  builder.box({-1.25, 0.7, -1.875}, {1.0, 0.75, -0.75});
  for (const double x : {-1.1875, 0.875}) {
    for (const double z : {-1.8125, -0.875}) builder.box({x, 0.0, z}, {x + 0.0625, 0.7, z + 0.0625});
  }
}

// A chair whose seat is half a metre square; `back` is 1 if its back is towards +z, -1 towards -z.
void add_chair(MeshBuilder& builder, double x, double z, double back) {
  builder.box({x - 0.25, 0.4375, z - 0.25}, {x + 0.25, 0.5, z + 0.25});
  for (const double dx : {-0.25, 0.1875}) {
    for (const double dz : {-0.25, 0.1875})
      builder.box({x + dx, 0.0, z + dz}, {x + dx + 0.0625, 0.4375, z + dz + 0.0625});
  }
  const double z_back = back > 0.0 ? z + 0.1875 : z - 0.25;
  builder.box({x - 0.25, 0.625, z_back}, {x + 0.25, 1.0, z_back + 0.0625});
  for (const double dx : {-0.25, 0.1875})
    builder.box({x + dx, 0.5, z_back}, {x + dx + 0.0625, 0.625, z_back + 0.0625});
}

// Pictures hang a centimetre before the wall, the carpet lies five millimetres above the floor.
void add_flat_things(MeshBuilder& builder) {
  builder.material("carpet", okabe_ito::reddish_purple);
  builder.parallelogram({-2.0, 0.005, -0.25}, {3.75, 0.0, 0.0}, {0.0, 0.0, -2.25});
  builder.material("frame", okabe_ito::dark_grey);
  builder.parallelogram({-2.25, 1.25, -3.99}, {1.5, 0.0, 0.0}, {0.0, 1.0, 0.0});
  builder.parallelogram({-2.99, 1.125, 0.25}, {0.0, 0.0, -1.25}, {0.0, 1.125, 0.0});
  builder.material("picture", okabe_ito::yellow);
  builder.parallelogram({-2.125, 1.375, -3.98}, {1.25, 0.0, 0.0}, {0.0, 0.75, 0.0});
  builder.parallelogram({-2.98, 1.25, 0.125}, {0.0, 0.0, -1.0}, {0.0, 0.875, 0.0});
  builder.material("door", okabe_ito::bluish_green);
  builder.parallelogram({1.25, 0.0, -3.99}, {1.0, 0.0, 0.0}, {0.0, 2.0, 0.0});
  builder.material("lamp", okabe_ito::vermilion);
  builder.box({-0.25, 1.75, -1.4375}, {0.0, 1.9375, -1.1875});
  builder.box({-0.140625, 1.9375, -1.328125}, {-0.109375, 2.75, -1.296875});
}

Scene make_room(std::span<const double>) {
  MeshBuilder builder("room");
  add_walls(builder);
  add_table(builder);
  builder.material("chair", okabe_ito::blue);
  add_chair(builder, -0.625, -0.5, 1.0);
  add_chair(builder, 0.5, -0.375, 1.0);
  add_chair(builder, -0.125, -2.125, -1.0);
  add_chair(builder, 2.375, 2.0, 1.0);  // beside the eye
  add_flat_things(builder);
  add_teapot(builder, 4, 0.075, {-0.125, 0.75, -1.3125});
  return builder.finish(
      {.eye = {1.625, 1.5, 2.5}, .target = {-0.375, 0.875, -1.5}, .vertical_fov_degrees = 50.0});
}

}  // namespace

constinit const SceneEntry room{.name = "room",
                                .title = "A room from inside",
                                .shows =
                                    "Walls, floor and ceiling pass the eye on all sides, so triangles must "
                                    "be cut where the eye's plane meets them.",
                                .parameters = {},
                                .make = make_room};

}  // namespace hsr::built_in
