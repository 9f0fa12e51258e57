#include "window/state_text.h"

#include <doctest/doctest.h>

#include "scene/errors.h"

namespace hsr::window {
namespace {

std::string message_of(const std::string& text) {
  try {
    (void)read_state_text(text, "a.hsr");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("window: a state written as text and read again is the same text") {
  State state;
  state.scene = "my scenes/two chairs.obj";
  state.moved = {{7, {0.1F, -2.5e-8F, 3.0F}}, {2, {1.0F, 2.0F, 3.0F}}};
  state.camera = Camera{{0.1, 0.2, 1.0 / 3.0}, {0.0, 1e-9, 0.0}, {0.0, 1.0, 0.0}, 33.3};
  state.picture = Extent{640, 360};
  state.algorithm = parse_algorithm_spec("zbuffer[depth=unorm16,snap=4]");
  state.skips_off = {"off-screen"};
  state.elsewhere = {Elsewhere::Kind::command, "my \"program\" --path a\\b # \n --all", true};
  state.show_elsewhere = true;
  state.comparing = Comparing::side_by_side;
  state.other = parse_algorithm_spec("painter[key=mean]");
  state.wiper = 0.25F;
  state.pixel = glm::ivec2(200, 140);
  state.magnification = 24.0F;
  state.centre = {0.3F, 0.7F};
  state.overlay = Overlay::list_length;
  state.log_depth = true;
  state.check = false;
  state.stepping = true;
  state.step = 12769;
  state.speed = 100.0F;
  state.steps_of = StepsOf::face;
  state.theme = Theme::light;
  state.scale = 1.5F;
  state.lecture = true;
  state.outside = true;
  const std::string text = state_text(state);
  const State read = read_state_text(text, "a.hsr");
  CHECK(state_text(read) == text);
  CHECK(read.scene == state.scene);
  CHECK(read.moved == state.moved);
  REQUIRE(read.elsewhere);
  CHECK(read.elsewhere->words == state.elsewhere->words);
  CHECK(!read.elsewhere->allowed);  // a state that was read runs no command
  REQUIRE(read.camera);
  CHECK(read.camera->eye == state.camera->eye);
  CHECK(read.algorithm.text() == "zbuffer[depth=unorm16,snap=4]");
  CHECK(read.pixel == state.pixel);
  CHECK(read.step == state.step);
  CHECK(read.overlay == state.overlay);
}

TEST_CASE("window: what is not in a state keeps its default") {
  const State read = read_state_text("hsr-state 1\n# a remark\n\nscene box\n", "a.hsr");
  CHECK(read.scene == "box");
  CHECK(read.algorithm.text() == default_algorithm().name);
  CHECK(!read.camera);
  CHECK(!read.pixel);
}

TEST_CASE("window: a state that is none is refused with file, line and reason") {
  CHECK(message_of("").find("a.hsr: this is no state") == 0);
  CHECK(message_of("v 0 0 0\n").find("this is no state") != std::string::npos);
  CHECK(message_of("hsr-state 2\n").find("version 2") != std::string::npos);
  const auto refused = [](const std::string& line, const std::string& reason) {
    CAPTURE(line);
    const std::string message = message_of("hsr-state 1\n" + line + "\n");
    CHECK(message.find("a.hsr:2: ") == 0);
    CHECK(message.find(reason) != std::string::npos);
  };
  refused("scene", "write: scene");
  refused("scenes box", "did you mean \"scene\"");
  refused("algorithm pointer", "unknown algorithm");
  refused("pixel 3 -1", "y");
  refused("pixel 1e9 2", "x");
  refused("picture 0 10", "width");
  refused("wiper 1.5", "wiper");
  refused("wiper nan", "wiper");
  refused("camera 0,0,1 0,0,0 0,1,0 0", "fov");
  refused("camera 0,0 0,0,0 0,1,0 45", "eye");
  refused("corner 4294967296 0,0,0", "corner");
  refused("theme green", "unknown word \"green\"");
  refused("lecture yes", "not on or off");
  refused("no-skip everything", "unknown skip");
  refused("step -1", "step");
  refused("scene \"box", "quote");
  CHECK(message_of("hsr-state 1\nscene box\nscene box\n").find("a.hsr:3: scene is given twice") == 0);
}

}  // namespace hsr::window
