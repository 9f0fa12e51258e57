#include <doctest/doctest.h>

#include <string>

#include "scene/reading.h"

using hsr::test::Corners;
using hsr::test::corners;
using hsr::test::Faces;
using hsr::test::faces;
using hsr::test::Lines;
using hsr::test::read_text;
using hsr::test::Reading;

namespace {

const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

std::string error_of(const std::string& text) { return read_text("a.off", text).error; }

}  // namespace

TEST_CASE("scene: OFF is read with comments, colours and blank lines between") {
  const Reading got =
      read_text("a.off",
                "OFF\n#\n# A square.\n\n4 2 0 # counts\n0 0 0.1\n1 0 0 # odd\n1 1 0\n\n  0 1 0\n"
                "4 0 1 2 3  1.0 0.0 0.0 0.75\n3\t0 1 2 255 0 0\n");
  CHECK(got.error.empty());
  CHECK(got.warnings.empty());
  REQUIRE(got.scene.positions.size() == 4);
  CHECK(got.scene.positions[0] == glm::vec3(0.0F, 0.0F, 0.1F));
  CHECK(corners(got.scene) == Corners{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}});
  CHECK(faces(got.scene) == Faces{0, 0, 1});
}

TEST_CASE("scene: OFF headers with letters, with counts, or none at all are understood") {
  const Corners want{{0, 1, 2}};
  for (const char* text :
       {"OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2",
        "OFF\n3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
        "COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 0 1 0 0 1\n3 0 1 2\n",
        "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n",
        "STCNOFF\n3 1 0\n0 0 0 0 0 1 1 1 1 1\n1 0 0 0 0 1 1 1 1 1\n0 1 0 0 0 1 1 1 1 1\n3 0 1 2\n",
        "OFF\r\n3 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0\r\n1 2\r\n"}) {
    CAPTURE(text);
    const Reading got = read_text("a.off", text);
    CHECK(got.error.empty());
    CHECK(got.warnings.empty());
    CHECK(corners(got.scene) == want);
    REQUIRE(got.scene.positions.size() == 3);
    CHECK(got.scene.positions[1] == glm::vec3(1, 0, 0));
  }
  CHECK(read_text("a.off", "OFF\n3 1 0\n0 0 0 9\n1 0 0\n0 1 0\n3 0 1 2\nmore\n").warnings ==
        Lines{"a.off:3: numbers after the position are ignored",
              "a.off:7: what follows the last face is ignored"});
}

TEST_CASE("scene: OFF faces that cannot be used are dropped and said") {
  const Reading got = read_text(
      "a.off", "OFF\n4 6 0\n0 0 0\n1 0 0\n1 1 inf\n0 x 0\n3 0 1 2\n2 0 1\n0\n3 0 1 7\n3 0 3 1\n3 0 1 1\n");
  CHECK(got.warnings == Lines{"a.off:5: vertex 2 is not finite", "a.off:6: vertex 3 is not finite",
                              "a.off:7: face dropped: its vertex 2 is not finite",
                              "a.off:8: face with 2 corners dropped", "a.off:9: face with 0 corners dropped",
                              "a.off:10: vertex index 7 out of range (4 vertices): face dropped",
                              "a.off:11: face dropped: its vertex 3 is not finite",
                              "a.off:12: face repeats a corner",
                              "a.off: 1 triangle has no area and will cover nothing"});
  CHECK(corners(got.scene) == Corners{{0, 1, 1}});
}

TEST_CASE("scene: broken OFF files are errors with line and reason") {
  CHECK(error_of("OFF\n4 2 0\n" + square + "3 0 1 2\n3 0") ==
        "a.off:8: truncated: the file ends after 1 of 2 faces");
  CHECK(error_of("OFF\n4 2 0\n" + square + "3 0 1 2\n") ==
        "a.off:8: truncated: the file ends after 1 of 2 faces");
  CHECK(error_of("OFF\n4 1 0\n0 0 0.0\n0 1 0.0\n1 1 1.0\n \n") ==
        "a.off:7: truncated: the file ends after 3 of 4 vertices");
  CHECK(error_of("OFF\n4000000000 1 0\n0 0 0\n") ==
        "a.off:2: truncated: 4000000000 vertices promised, but only 7 bytes left");
  CHECK(error_of("OFF\n1 4000000000 0\n0 0 0\n") ==
        "a.off:2: truncated: 4000000000 faces promised, but only 7 bytes left");
  CHECK(error_of("OFF\n4 1 0\n" + square + "4000000000 0 1 2\n") ==
        "a.off:7: truncated: the file ends after 0 of 1 faces");
  CHECK(error_of("OFF\n4 -1 0\n" + square) == "a.off:2: negative number of faces");
  CHECK(error_of("OFF\n4 1 0\n0 0 0\n1 0\n1 1 0\n0 1 0\n3 0 1 2\n") == "a.off:4: vertex has 2 numbers of 3");
  CHECK(error_of("OFF\n4 2 0\n" + square + "3 0 1\n3 0 1 2\n") ==
        "a.off:7: face has fewer than its 3 corners");
  CHECK(error_of("OFF\n4 1 0\n" + square + "3 0 1 b\n") == "a.off:7: 'b' is not a vertex index");
  CHECK(error_of("OFF\n4 1 0\n" + square + "x 0 1 2\n") == "a.off:7: number of corners expected, not 'x'");
  CHECK(error_of("OFF\nfour 1 0\n") == "a.off:2: numbers of vertices and faces expected, not 'four'");
  CHECK(error_of("OFF\n") == "a.off:2: the file ends before its counts");
  CHECK(error_of("OFF BINARY\n") == "a.off:1: binary OFF is not supported");
  CHECK(error_of("4OFF\n1 1 0\n") ==
        "a.off:1: OFF with other than three dimensions ('4OFF') is not supported");
  CHECK(error_of("DOG\n1 1 0\n") == "a.off:1: not an OFF file: it begins with 'DOG'");
  CHECK(error_of("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n") ==
        "a.off:6: vertex index 9 out of range (3 vertices)");
}
