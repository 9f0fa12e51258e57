#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "scene/reading.h"

using hsr::test::Corners;
using hsr::test::corners;
using hsr::test::Faces;
using hsr::test::faces;
using hsr::test::Lines;
using hsr::test::read_file;
using hsr::test::read_text;
using hsr::test::Reading;
using hsr::test::TemporaryFolder;

namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

}  // namespace

TEST_CASE("scene: OBJ positions and triangles are read in file order") {
  const Reading got =
      read_text("a.obj", "# a comment\nv 0.1 -2e3 .5\nv +1 0 0\n\nv 0 1 0\nf 1 2 3\nf 3 2 1\n");
  CHECK(got.error.empty());
  CHECK(got.warnings.empty());
  CHECK(got.scene.name == "a.obj");
  CHECK_FALSE(got.scene.camera);
  REQUIRE(got.scene.positions.size() == 3);
  CHECK(got.scene.positions[0] == glm::vec3(0.1F, -2000.0F, 0.5F));
  CHECK(corners(got.scene) == Corners{{0, 1, 2}, {2, 1, 0}});
  CHECK(faces(got.scene) == Faces{0, 1});
  CHECK(got.scene.triangles[0].material == hsr::no_material);
}

TEST_CASE("scene: OBJ polygons are cut in place and remember their face") {
  const Reading got = read_text("a.obj", square + "v 2 2 0\nf 1 2 3 4\nf 2 5 3\nf 1/1 2/2 3/3 4/4\nvt 0 0\n");
  CHECK(corners(got.scene) == Corners{{0, 1, 2}, {0, 2, 3}, {1, 4, 2}, {0, 1, 2}, {0, 2, 3}});
  CHECK(faces(got.scene) == Faces{0, 0, 1, 2, 2});
}

TEST_CASE("scene: a negative OBJ index counts back from the last vertex") {
  const Reading got = read_text("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -1 -4 -2\n");
  CHECK(got.warnings.empty());
  CHECK(corners(got.scene) == Corners{{0, 1, 2}, {3, 0, 2}});
}

TEST_CASE("scene: an OBJ face may come before its vertices and keeps its place") {
  const Reading got = read_text("a.obj", square + "f 1 2 3\nf 2 5 6\nf 1 3 4\nv 2 2 0\nv 3 2 0\nf 4 5 6\n");
  CHECK(got.warnings.empty());
  CHECK(corners(got.scene) == Corners{{0, 1, 2}, {1, 4, 5}, {0, 2, 3}, {3, 4, 5}});
  CHECK(faces(got.scene) == Faces{0, 1, 2, 3});
}

TEST_CASE("scene: all spellings of OBJ lines mean the same") {
  const Corners want{{0, 1, 2}, {0, 2, 3}};
  for (const std::string& text : {
           std::string("\xEF\xBB\xBF") + square + "f 1 2 3 4",                            // byte order mark
           std::string("v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nf 1 2 3 4\r\n"),      // CR LF
           std::string("v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3 4"),                  // CR alone
           std::string("v 0 0 \\\n0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2\\\n 3 \\\r\n4\n"),  // continued lines
           "  \t" + square + "f\t1  2\v3\f4   \n",                                        // blanks
           square + "f 1 2 3 4 # and why\n",
           square + "fo 1 2 3 4\n",
           square + "f 1// 2// 3// 4//\n",
           square + "vt 0 0\nvn 0 0 1\nf 1/1/1 2//1 3/1 4/-1/-1\n",
           "# path: C:\\mesh\\\n" + square + "f 1 2 3 4\n",
           std::string(
               "v 0 0 0 1\nv 1 0 0 0.5\nv 1 1 0 1 0 0\nv 0 1 0 0.1 0.2 0.3\nf 1 2 3 4\n"),  // weights,
                                                                                            // colours
           square + "o a f 1 2 3\ng f 1 2 3\ns off\nl 1 2\np 1\nvp 0 0\nf 1 2 3 4\n",
       }) {
    CAPTURE(text);
    const Reading got = read_text("a.obj", text);
    CHECK(got.error.empty());
    CHECK(got.warnings.empty());
    CHECK(corners(got.scene) == want);
  }
}

TEST_CASE("scene: OBJ faces with a bad index are dropped, each with its line, and the others stay") {
  const Reading got = read_text("a.obj", square + "f 1 2 99\nf 0 1 2\nf -9 1 2\nf 1 2 3\n");
  CHECK(got.error.empty());
  CHECK(got.warnings == Lines{"a.obj:5: vertex index 99 out of range (4 vertices): face dropped",
                              "a.obj:6: vertex index 0 out of range (OBJ counts from 1): face dropped",
                              "a.obj:7: vertex index -9 out of range (4 vertices so far): face dropped"});
  CHECK(corners(got.scene) == Corners{{0, 1, 2}});
  CHECK(faces(got.scene) == Faces{0});
}

TEST_CASE("scene: an OBJ file whose faces all have bad indices is an error") {
  CHECK(read_text("a.obj", "vt 0 0\nf 1/-1 1/-1 1/-2\n").error ==
        "a.obj:2: vertex index 1 out of range (0 vertices)");
  CHECK(read_text("a.obj", square + "f 1 2 99999999999999999999\n").error ==
        "a.obj:5: vertex index 1000000000000000000 out of range (4 vertices)");
}

TEST_CASE("scene: OBJ vertices that are not finite spoil only their own faces") {
  const Reading got = read_text(
      "a.obj",
      square + "v nan 0 0\nv 0 -inf 0\nv 1.#IND 0 0\nv 0 0 zero\nv 1e400 0 0\nv 7\nf 1 2 5\nf 1 2 3\n");
  CHECK(got.warnings == Lines{"a.obj:5: vertex 5 is not finite", "a.obj:6: vertex 6 is not finite",
                              "a.obj:7: vertex 7: '1.#IND' is not a number",
                              "a.obj:8: vertex 8: 'zero' is not a number", "a.obj:9: vertex 9 is not finite",
                              "a.obj:11: face dropped: its vertex 5 is not finite",
                              "a.obj: and 1 more vertices that are not finite"});
  CHECK(corners(got.scene) == Corners{{0, 1, 2}});
  REQUIRE(got.scene.positions.size() == 10);
  for (const glm::vec3& position : got.scene.positions) {
    CHECK(position == position);
    CHECK(std::abs(position.x) < 2.0F);
  }
}

TEST_CASE("scene: odd OBJ lines are said and passed over") {
  CHECK(read_text("a.obj", "v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n").warnings ==
        Lines{"a.obj:1: vertex has only x and y: z is taken as 0",
              "a.obj:2: vertex has only x and y: z is taken as 0",
              "a.obj:3: vertex has only x and y: z is taken as 0"});
  CHECK(read_text("a.obj", "v 0 0 0 nan nan nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").warnings ==
        Lines{"a.obj:1: bad number after the vertex position: ignored"});
  CHECK(read_text("a.obj", square + "f 1 2 3\nf 1\nf 1 2\nf\n").warnings ==
        Lines{"a.obj:6: face with 1 corner dropped", "a.obj:7: face with 2 corners dropped",
              "a.obj:8: face with 0 corners dropped"});
  CHECK(read_text("a.obj", square + "f 1 2 3\nf 1 2 x3\nf 1 2 3/a\nf 1 2 3/1/1/1\n").warnings ==
        Lines{"a.obj:6: 'x3' is not a corner: face dropped", "a.obj:7: '3/a' is not a corner: face dropped",
              "a.obj:8: '3/1/1/1' is not a corner: face dropped"});
  CHECK(read_text("a.obj", square + "f 1//1 2//1 3//1\n").warnings ==
        Lines{"a.obj:5: normal index 1 out of range (0 so far): ignored"});
  CHECK(read_text("a.obj", square + "f 1 2 3\nnonsense\n").warnings ==
        Lines{"a.obj:6: 'nonsense' is not understood: line ignored"});
  CHECK(read_text("a.obj", square + "f 1 1 3\n").warnings ==
        Lines{"a.obj:5: face repeats a corner", "a.obj: 1 triangle has no area and will cover nothing"});
  CHECK(read_text("a.obj", square + "f 1 3 2 4\n").warnings ==
        Lines{"a.obj:5: face's outline crosses itself"});
}

TEST_CASE("scene: OBJ line numbers count joined lines, too") {
  CHECK(read_text("a.obj", square + "l 1 \\\n 2\nf 1 2 3\nf 1 \\\n 2 \\\n 99\nf 2\n").warnings ==
        Lines{"a.obj:8: vertex index 99 out of range (4 vertices): face dropped",
              "a.obj:11: face with 1 corner dropped"});
}

TEST_CASE("scene: many OBJ warnings of one kind are counted") {
  std::string text = square + "f 1 2 3\n";
  for (int i = 0; i < 12; ++i) {
    text += "f 1 2\n";
  }
  const Reading got = read_text("a.obj", text);
  REQUIRE(got.warnings.size() == 6);
  CHECK(got.warnings[4] == "a.obj:10: face with 2 corners dropped");
  CHECK(got.warnings[5] == "a.obj: and 7 more faces with fewer than 3 corners");
}

TEST_CASE("scene: an OBJ file without faces loads and says so") {
  CHECK(read_text("a.obj", square + "l 1 2 3\n").warnings == Lines{"a.obj: no faces, only 4 vertices"});
  CHECK(read_text("a.obj", "# nothing\n").warnings == Lines{"a.obj: no faces"});
}

TEST_CASE("scene: an OBJ face of very many repeated corners is said and does not stall") {
  std::string face = "f";
  for (int i = 0; i < 20000; ++i) {
    face += " 1 2 3 4";
  }
  const Reading got = read_text("a.obj", square + face + "\nf 1 2 3\n");
  CHECK(got.scene.triangles.size() == 79999);
  CHECK(got.scene.triangles.back().face == 1);
  REQUIRE(got.warnings.size() >= 1);
  CHECK(got.warnings[0] == "a.obj:5: face repeats a corner");
}

TEST_CASE("scene: OBJ materials come from the MTL file, in the order of their use") {
  const TemporaryFolder folder;
  folder.write(
      "m.mtl",
      "newmtl unused\nKd 1 1 1\nnewmtl red\nKd 1 0.25 0 # comment\nd 0.5\nnewmtl Dark Blue\nTr 0.75\n"
      "Kd 0.125\nillum 2\nmap_Kd a.png\n");
  folder.write("a.obj",
               "mtllib m.mtl\n" + square +
                   "f 1 2 3\nusemtl Dark Blue\nf 1 2 3 4\nusemtl red\nf 1 2 3\nusemtl Dark Blue\nf 1 2 "
                   "3\nusemtl unused\n");
  const Reading got = read_file(folder, "a.obj");
  CHECK(got.warnings.empty());
  REQUIRE(got.scene.materials.size() == 2);
  CHECK(got.scene.materials[0].name == "Dark Blue");
  CHECK(got.scene.materials[0].color == glm::vec3(0.125F));
  CHECK(got.scene.materials[0].opacity == 0.25F);
  CHECK(got.scene.materials[1].color == glm::vec3(1.0F, 0.25F, 0.0F));
  CHECK(got.scene.materials[1].opacity == 0.5F);
  REQUIRE(got.scene.triangles.size() == 5);
  CHECK(got.scene.triangles[0].material == hsr::no_material);
  CHECK(got.scene.triangles[1].material == 0);
  CHECK(got.scene.triangles[2].material == 0);
  CHECK(got.scene.triangles[3].material == 1);
  CHECK(got.scene.triangles[4].material == 0);
}

TEST_CASE("scene: MTL libraries are found under names with blanks, backslashes and other capitals") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "sub");
  folder.write("my library.mtl", "newmtl a\nKd 1 0 0\n");
  folder.write("sub/Other.MTL", "newmtl b\nKd 0 1 0\n");
  folder.write("third.mtl", "newmtl c\nKd 0 0 1\nnewmtl a\nKd 1 1 1\n");
  folder.write("a.obj", "mtllib my library.mtl\nmtllib sub\\other.mtl third.mtl\n" + square +
                            "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl c\nf 1 2 3\n");
  const Reading got = read_file(folder, "a.obj");
  REQUIRE(got.scene.materials.size() == 3);
  CHECK(got.scene.materials[0].color == glm::vec3(1, 0, 0));
  CHECK(got.scene.materials[1].color == glm::vec3(0, 1, 0));
  CHECK(got.scene.materials[2].color == glm::vec3(0, 0, 1));
  CHECK(got.warnings == Lines{"third.mtl:3: material 'a' is defined twice: the first one counts"});
}

TEST_CASE("scene: missing and bad materials are said and the palette takes their place") {
  const TemporaryFolder folder;
  folder.write("bad.mtl", "newmtl r\nKd 2 -1 x\nd nan\nnewmtl g\nKd 0.5 1.5 0.5\nTr 0.25\nd 0.5\n");
  folder.write("a.obj", "mtllib no.mtl\nmtllib bad.mtl\n" + square +
                            "usemtl r\nf 1 2 3\nusemtl x\nf 1 2 3\nusemtl y\nf 1 2 3\nusemtl g\nf 1 2 3\n");
  const Reading got = read_file(folder, "a.obj");
  CHECK(got.warnings ==
        Lines{"a.obj:1: material library 'no.mtl' cannot be read: no such file",
              "a.obj:9: materials 'x', 'y' are not defined: colours are chosen by face",
              "bad.mtl:2: value out of [0, 1]: clamped", "bad.mtl:2: value out of [0, 1]: clamped",
              "bad.mtl:2: 'x' is not a number: left out", "bad.mtl:3: 'nan' is not a number: left out",
              "bad.mtl:5: value out of [0, 1]: clamped"});
  REQUIRE(got.scene.materials.size() == 2);
  CHECK(got.scene.materials[1].color == glm::vec3(0.5F, 1.0F, 0.5F));
  CHECK(got.scene.materials[1].opacity == 0.5F);
  CHECK(got.scene.triangles[1].material == hsr::no_material);
  CHECK(got.scene.triangles[3].material == 1);
}

TEST_CASE("scene: what is not OBJ text is an error that says so") {
  CHECK(read_text("a.obj", "").error == "a.obj: empty file");
  CHECK(read_text("a.obj", std::string("v 3E4570711268\0", 15)).error ==
        "a.obj:1: not a text file: byte 14 is NUL");
  CHECK(read_text("a.obj", std::string("\xFE\xFF\0v\0 \0"
                                       "1",
                                       8))
            .error == "a.obj: the text is UTF-16: save it as UTF-8");
  CHECK(read_text("a.obj", "\x80\x81\x82 rubbish\nmore of it\n").error ==
        "a.obj: not an OBJ file: none of its lines is understood");
}
