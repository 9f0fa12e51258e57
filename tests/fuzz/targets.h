#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace hsr::fuzz {

/// Thrown by a target when the kit breaks a promise. Uncaught, it ends a fuzzer's run like any crash.
class Broken : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Throws Broken with what is said of it unless `holds`.
inline void require(bool holds, std::string_view promise) {
  if (!holds) throw Broken(std::string(promise));
}

// One function a target, each in targets/NAME.cpp: hands any bytes to a part of the kit and checks
// what comes back. The errors that the part promises are caught; every other exception is a bug.
void obj(std::string_view bytes);
void ply(std::string_view bytes);
void off(std::string_view bytes);
void stl(std::string_view bytes);
void gltf(std::string_view bytes);
void glb(std::string_view bytes);
void any_format(std::string_view bytes);
void spec(std::string_view bytes);
void built_in_scene(std::string_view bytes);
void values(std::string_view bytes);
void state(std::string_view bytes);
void script(std::string_view bytes);
void render(std::string_view bytes);

struct Target {
  std::string_view name;
  void (*run)(std::string_view bytes);
};

/// Every target, for those who run them all.
std::span<const Target> targets();

}  // namespace hsr::fuzz
