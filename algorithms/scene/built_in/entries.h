#pragma once

#include "scene/catalog.h"

/// The built-in scenes, each defined with its parameters in a file of this folder and listed in
/// scene/catalog.cpp. All are constants, so the order of initialization does not matter.
namespace hsr::built_in {

extern const SceneEntry box;
extern const SceneEntry cube;
extern const SceneEntry three_bars;
extern const SceneEntry crossing;
extern const SceneEntry hair_apart;
extern const SceneEntry bumpy_sphere;
extern const SceneEntry soup;
extern const SceneEntry big_soup;

}  // namespace hsr::built_in
