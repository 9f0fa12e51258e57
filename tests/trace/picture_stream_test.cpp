#include "trace/picture_stream.h"

#include <doctest/doctest.h>

#include <random>
#include <sstream>
#include <string>

#include "scene/errors.h"
#include "support/effort.h"

namespace hsr::test {
namespace {

constexpr std::uint32_t triangles = 10;

/// 3 x 2 pixels with colours, lists, a view and steps.
ToldPicture small_picture() {
  ToldPicture picture;
  Frame& frame = picture.frame;
  frame = Frame(3, 2);
  frame.id[1] = 7;
  frame.depth[1] = 2.5F;
  frame.color[1] = {0.25F, 0.5F, 0.125F, 1.0F};
  frame.lists = FragmentLists{{0, 0, 2, 2, 2, 2, 3}, {{7, 2.5F, false}, {8, 2.5F, true}, {9, 4.0F, false}}};
  picture.view = ToldView{{{0.1, 2, 3}, {0, 1.0 / 3.0, 0}, {0, 1, 0}, 33.3}, 0.5, 20.0};
  picture.tells_steps = true;
  picture.steps = {{.kind = EventKind::key_given, .p = 3, .value = 0.1},
                   {.kind = EventKind::painted, .i = 1, .j = 0, .p = 7, .value = 2.5}};
  return picture;
}

std::string stream_of(const ToldPicture& picture) {
  std::ostringstream stream;
  write_picture_stream(picture, stream);
  return stream.str();
}

ToldPicture read(const std::string& text, PictureLimits limits = {.triangles = triangles}) {
  std::istringstream stream(text);
  return read_picture_stream(stream, "a", limits);
}

void fails(const std::string& text, const std::string& reason,
           PictureLimits limits = {.triangles = triangles}) {
  CAPTURE(text.substr(0, 200));
  try {
    (void)read(text, limits);
    FAIL_CHECK("it was read");
  } catch (const InputError& error) {
    const std::string message = error.what();
    CAPTURE(message);
    CHECK(message.starts_with("a: "));
    CHECK(message.find(reason) != std::string::npos);
  }
}

std::string numbers(std::size_t count, char byte) { return std::string(4 * count, byte); }

}  // namespace

TEST_CASE("trace: a picture that was written to a stream comes back the same") {
  const ToldPicture picture = small_picture();
  const ToldPicture back = read(stream_of(picture));
  CHECK(back.frame.width == 3);
  CHECK(back.frame.height == 2);
  CHECK(back.frame.id == picture.frame.id);
  CHECK(back.frame.depth == picture.frame.depth);
  CHECK(back.frame.color == picture.frame.color);
  REQUIRE(back.frame.lists);
  CHECK(back.frame.lists->begin == picture.frame.lists->begin);
  CHECK(back.frame.lists->fragments[1].id == 8);
  CHECK(back.frame.lists->fragments[1].tied);
  CHECK(back.view == picture.view);
  CHECK(back.tells_steps);
  CHECK(back.steps == picture.steps);
}

TEST_CASE("trace: ids and depths are enough for a picture, in any order") {
  const std::string none = numbers(2, '\xFF');
  const ToldPicture back =
      read("hsr-picture 1 2 1\ndepth 8\n" + numbers(2, '\0') + "id 8\n" + none + "end 0\n");
  CHECK(back.frame.color.empty());
  CHECK(!back.frame.lists);
  CHECK(!back.tells_steps);
  CHECK(back.frame.id[0] == background_id);
  CHECK(back.frame.depth[0] == std::numeric_limits<float>::infinity());
}

TEST_CASE("trace: what is no picture is refused with the reason") {
  const std::string head = "hsr-picture 1 2 1\n";
  const std::string id = "id 8\n" + numbers(2, '\0');
  const std::string depth = "depth 8\n" + numbers(2, '\0');
  fails("", "it is empty");
  fails("Segmentation fault\n", "this is no picture");
  fails(std::string(100000, 'x'), "xxx");
  fails("hsr-picture 2 2 1\n", "version 2");
  fails("hsr-picture 1 0 1\n", "width and height");
  fails("hsr-picture 1 2000000000 2000000000\n", "width and height");
  fails(head + id + depth, "ends before");
  fails(head + depth + "end 0\n", "section id is missing");
  fails(head + id + "end 0\n", "section depth is missing");
  fails(head + id + id, "twice");
  fails(head + "id 12\n", "in place of 8");
  fails(head + "id 8\nabc", "cut off");
  fails(head + "id 99999999999999999999999\n", "NAME BYTES");
  fails(head + "picture 8\n", "no section \"picture\"");
  fails(head + "id 8\n" + numbers(1, '\0') + numbers(1, '\1') + depth + "end 0\n",
        "pixel 1, 0: there is no triangle");
  fails(head + id + "depth 8\n" + numbers(2, '\x7F') + "\x7F\n", "NAME BYTES");
  fails(head + id + "depth 8\n" + numbers(2, '\xFF') + "end 0\n", "pixel 0, 0: the depth is no number");
  fails(head + "color 32\n" + numbers(8, '\xFF') + id + depth + "end 0\n", "colour");
  fails(head + "lists 8\n" + numbers(2, '\x7F'), "too many");
  fails(head + "lists 4\n", "too short");
  fails(head + "camera 6\n1 2 3\n", "twelve numbers");
  fails(head + "camera 100000000\n", "too long");
  fails(head + "steps 2\n{}", "step 1: ");
  const auto step = [&](const std::string& line) {
    return head + "steps " + std::to_string(line.size()) + "\n" + line;
  };
  fails(step(R"({"step":1,"kind":"painted","p":1})"), "at no pixel");
  fails(step(R"({"step":1,"kind":"painted","p":1,"i":2,"j":0})"), "at no pixel");
  fails(step(R"({"step":1,"kind":"painted","p":10,"i":1,"j":0})"), "a triangle that the scene does not have");
  fails(step(R"({"step":1,"kind":"painted","i":1,"j":0})"), "a triangle that the scene does not have");
  fails(step("{\"step\":1,\"kind\":\"split\",\"p\":1}\n{\"step\":1,\"kind\":\"split\",\"p\":1}"),
        "more than 1 steps", {.triangles = triangles, .steps = 1});
}

TEST_CASE("trace: a picture with any bytes changed, or cut off anywhere, is read or refused") {
  const std::string whole = stream_of(small_picture());
  for (std::size_t length = 0; length < whole.size(); ++length) fails(whole.substr(0, length), "");
  std::mt19937 random(5);
  for (std::uint64_t k = 0; k < cases(2000); ++k) {
    std::string text = whole;
    for (int change = 0; change < 3; ++change) text[random() % text.size()] = static_cast<char>(random());
    try {
      const ToldPicture back = read(text);
      CHECK(back.frame.id.size() == back.frame.pixel_count());
      CHECK(back.frame.depth.size() == back.frame.pixel_count());
    } catch (const InputError&) {
    }
  }
}

}  // namespace hsr::test
