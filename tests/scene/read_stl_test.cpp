#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "scene/bytes.h"
#include "scene/reading.h"

using hsr::test::bytes_of;
using hsr::test::Corners;
using hsr::test::corners;
using hsr::test::Faces;
using hsr::test::faces;
using hsr::test::Lines;
using hsr::test::read_text;
using hsr::test::Reading;

namespace {

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return " facet normal 0 0 1\n  outer loop\n   vertex " + a + "\n   vertex " + b + "\n   vertex " + c +
         "\n  endloop\n endfacet\n";
}

std::string binary(const std::string& header, std::uint32_t promised, int triangles, float x) {
  std::string text =
      header + std::string(80 - header.size(), header.empty() ? '\0' : ' ') + bytes_of(promised);
  for (int i = 0; i < triangles; ++i) {
    for (const float value : {0.0F, 0.0F, 1.0F, x, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.5F}) {
      text += bytes_of(value);
    }
    text += "ab";
  }
  return text;
}

}  // namespace

TEST_CASE("scene: ASCII STL is read, with several solids, capitals and larger loops") {
  const Reading got = read_text("a.stl", "solid one f\n" + facet("0 0 0", "1 0 0", "0 1 0.1") +
                                             "endsolid one\nSOLID two\nFACET NORMAL 0 0 1\nOUTER LOOP\n"
                                             "VERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 1 1 0\nVERTEX 0 1 0\n"
                                             "ENDLOOP\nENDFACET\nENDSOLID\n");
  CHECK(got.error.empty());
  CHECK(got.warnings.empty());
  CHECK(corners(got.scene) == Corners{{0, 1, 2}, {3, 4, 5}, {3, 5, 6}});
  CHECK(faces(got.scene) == Faces{0, 1, 1});
  CHECK(got.scene.positions[2] == glm::vec3(0, 1, 0.1F));
}

TEST_CASE("scene: binary STL is read, even when its header begins as text does") {
  for (const std::string& header : {std::string(), std::string("solid facet")}) {
    const Reading got = read_text("a.stl", binary(header, 2, 2, 0.25F));
    CHECK(got.error.empty());
    CHECK(got.warnings.empty());
    CHECK(corners(got.scene) == Corners{{0, 1, 2}, {3, 4, 5}});
    CHECK(got.scene.positions[0] == glm::vec3(0.25F, 0, 0));
    CHECK(got.scene.positions[5] == glm::vec3(0, 1, 0.5F));
  }
}

TEST_CASE("scene: STL facets that are not finite or have too few corners are dropped and said") {
  CHECK(read_text("a.stl", binary("", 1, 1, NAN)).warnings ==
        Lines{"a.stl: byte 84: vertex 0 is not finite",
              "a.stl: byte 84: face dropped: its vertex 0 is not finite",
              "a.stl: no faces, only 3 vertices"});
  const Reading got =
      read_text("a.stl", "solid\n" + facet("0 0 0", "1 0 0", "0 1 x") +
                             "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\nendfacet\n" +
                             facet("0 0 0", "1 0 0", "2 0 0") + "hello\n");
  CHECK(got.warnings ==
        Lines{"a.stl:2: vertex 2 is not finite", "a.stl:2: face dropped: its vertex 2 is not finite",
              "a.stl:9: face with 1 corner dropped", "a.stl:21: 'hello' is not understood: line ignored",
              "a.stl: no endsolid: the file may be cut off",
              "a.stl: 1 triangle has no area and will cover nothing"});
  CHECK(got.scene.triangles.size() == 1);
}

TEST_CASE("scene: STL files that are cut off or no STL are errors") {
  const auto error = [](const std::string& text) { return read_text("a.stl", text).error; };
  CHECK(error(binary("", 3, 2, 0)) == "a.stl: truncated: the file ends after 2 of 3 triangles");
  CHECK(error(binary("solid x", 4000000000U, 2, 0)) ==
        "a.stl: truncated: the file ends after 2 of 4000000000 triangles");
  CHECK(read_text("a.stl", binary("", 1, 2, 0)).warnings ==
        Lines{"a.stl: 50 bytes after the last triangle ignored"});
  CHECK(error("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nver") ==
        "a.stl:2: truncated: the file ends within this facet");
  CHECK(error("solid\nfacet normal 0 0 1\nvertex 0 0\n") == "a.stl:3: vertex has 2 numbers of 3");
  CHECK(error("solid\nvertex 0 0 0\nfacet\n") == "a.stl:2: vertex outside of a facet");
  CHECK(error("solid\nfacet normal 0 0 1\nvertex 0 0 0\nfacet normal 0 0 1\n") ==
        "a.stl:4: facet within the facet of line 2");
  CHECK(error("rubbish") ==
        "a.stl: not an STL file: neither text that begins with 'solid' nor 84 bytes of binary header");
  CHECK(read_text("a.stl", "solid nothing\nendsolid nothing\n").warnings == Lines{"a.stl: no faces"});
}
