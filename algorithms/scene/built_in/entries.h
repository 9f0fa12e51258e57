#pragma once

#include "scene/catalog.h"

/// The built-in scenes, each defined with its parameters in a file of this folder and listed in
/// scene/catalog.cpp. All are constants, so the order of initialization does not matter.
namespace hsr::built_in {

extern const SceneEntry aligned_grid;
extern const SceneEntry behind_a_wall;
extern const SceneEntry big_and_small;
extern const SceneEntry big_soup;
extern const SceneEntry box;
extern const SceneEntry bumpy_sphere;
extern const SceneEntry city;
extern const SceneEntry coplanar;
extern const SceneEntry crossing;
extern const SceneEntry cube;
extern const SceneEntry degenerate;
extern const SceneEntry duplicate_cube;
extern const SceneEntry fan;
extern const SceneEntry far_away;
extern const SceneEntry glass;
extern const SceneEntry hair_apart;
extern const SceneEntry hair_behind;
extern const SceneEntry inside_soup;
extern const SceneEntry layers;
extern const SceneEntry needles;
extern const SceneEntry one_cell;
extern const SceneEntry room;
extern const SceneEntry separate;
extern const SceneEntry sheets;
extern const SceneEntry soup;
extern const SceneEntry stadium;
extern const SceneEntry stretched;
extern const SceneEntry teapot;
extern const SceneEntry terrain;
extern const SceneEntry three_bars;
extern const SceneEntry three_cycles;
extern const SceneEntry woven;

}  // namespace hsr::built_in
