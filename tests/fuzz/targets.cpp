#include "fuzz/targets.h"

#include <array>

namespace hsr::fuzz {

std::span<const Target> targets() {
  static constexpr std::array all {
    Target{"obj", obj}, Target{"ply", ply}, Target{"off", off}, Target{"stl", stl}, Target{"gltf", gltf},
        Target{"glb", glb}, Target{"any_format", any_format}, Target{"spec", spec},
        Target{"built_in_scene", built_in_scene},
#if HSR_FUZZ_PROGRAM
        Target{"values", values}, Target{"state", state}, Target{"script", script},
#endif
        Target{"render", render},
  };
  return all;
}

}  // namespace hsr::fuzz
