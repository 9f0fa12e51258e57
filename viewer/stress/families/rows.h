#pragma once

#include "stress/family.h"

/// The families, each a row with its scene, in the files of this folder.
namespace hsr::stress::rows {

// Depths that are close.
extern const Family planes_apart;
extern const Family depth_ratio;
extern const Family coplanar;
extern const Family grazing;
extern const Family layers;

// Edges that pass close to the centres of pixels.
extern const Family near_centres;
extern const Family on_centres;
extern const Family aimed;
extern const Family needles;
extern const Family kettner;

// Where things lie.
extern const Family moved;
extern const Family scaled_up;
extern const Family scaled_down;
extern const Family eye_plane;
extern const Family near_plane;

// Orders that do not exist, and meshes that are not clean.
extern const Family bars;
extern const Family crossing;
extern const Family inside;
extern const Family mixed;

}  // namespace hsr::stress::rows
