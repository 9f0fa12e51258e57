#include <doctest/doctest.h>

#include <bit>
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

const std::string vertex3 = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string vertex4 = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string face = "property list uchar int vertex_indices\n";
const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

std::string ascii(const std::string& elements, const std::string& body) {
  return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + body;
}

std::string error_of(const std::string& text) { return read_text("a.ply", text).error; }

/// A binary file with odd types in odd places, in either order of bytes.
std::string binary(std::endian order) {
  const bool little = order == std::endian::little;
  std::string text = "ply\nformat " + std::string(little ? "binary_little_endian" : "binary_big_endian") +
                     " 1.0\ncomment element vertex 99\nelement camera 2\nproperty list ushort double matrix\n"
                     "element vertex 4\nproperty uchar red\nproperty double y\nproperty short x\n"
                     "property list uint8 int8 tags\nproperty float32 z\nelement face 2\nproperty int flags\n"
                     "property list uint ushort vertex_index\nproperty uint16 group\nend_header\n";
  const auto put = [&](auto value) { text += bytes_of(value, order); };
  put(std::uint16_t{1});
  put(2.5);
  put(std::uint16_t{0});
  for (int i = 0; i < 4; ++i) {
    put(std::uint8_t{7});
    put(i < 2 ? 0.1 : 1.1);
    put(static_cast<std::int16_t>(i == 1 || i == 2 ? -300 : 0));
    put(std::uint8_t{2});
    put(std::int8_t{1});
    put(std::int8_t{-1});
    put(static_cast<float>(i));
  }
  for (const std::uint16_t count : {std::uint16_t{4}, std::uint16_t{3}}) {
    put(std::int32_t{-5});
    put(std::uint32_t{count});
    for (std::uint16_t corner = 0; corner < count; ++corner) {
      put(corner);
    }
    put(std::uint16_t{3});
  }
  return text;
}

}  // namespace

TEST_CASE("scene: ASCII PLY is read, polygons and extra properties too") {
  const Reading got = read_text(
      "a.ply",
      ascii("comment made by hand\nobj_info x\nelement vertex 4\nproperty uchar red\nproperty double x\n"
            "property list uchar int tags\nproperty float y\nproperty float z\nelement edge 1\n"
            "property int a\nelement face 2\n" +
                face + "property uchar flag\n",
            "9 0.1 2 5 6 -2.5 1e-3\n9 1 0 0 0\n9 1 1 3 1 0\n\n9 0 0 1 0\n17\n4 0 1 2 3 1\n3 2 1 0 0\n"));
  CHECK(got.error.empty());
  CHECK(got.warnings.empty());
  REQUIRE(got.scene.positions.size() == 4);
  CHECK(got.scene.positions[0] == glm::vec3(0.1F, -2.5F, 1e-3F));
  CHECK(faces(got.scene) == Faces{0, 0, 1});
  CHECK(got.scene.triangles.back().corners == std::array<std::uint32_t, 3>{2, 1, 0});
}

TEST_CASE("scene: binary PLY is read in both orders of bytes") {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const Reading got = read_text("a.ply", binary(order));
    CHECK(got.error.empty());
    CHECK(got.warnings.empty());
    REQUIRE(got.scene.positions.size() == 4);
    CHECK(got.scene.positions[0] == glm::vec3(0.0F, 0.1F, 0.0F));
    CHECK(got.scene.positions[2] == glm::vec3(-300.0F, 1.1F, 2.0F));
    CHECK(faces(got.scene) == Faces{0, 0, 1});
    CHECK(got.scene.triangles[2].corners == std::array<std::uint32_t, 3>{0, 1, 2});
  }
}

TEST_CASE("scene: a double of binary PLY is rounded to float32 once") {
  std::string text =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
      "property double z\nelement face 1\n" +
      face + "end_header\n";
  const std::size_t body = text.size();
  for (const double value : {0x1.000001p0, 0x1.0000010000001p0, -0.0, 0.0, 1e-46, 1.0, 1.0, 2.0, 1e300}) {
    text += bytes_of(value);
  }
  text += std::string("\3") + bytes_of(0) + bytes_of(1) + bytes_of(2);
  const Reading got = read_text("a.ply", text);
  REQUIRE(got.scene.positions.size() == 3);
  CHECK(got.warnings ==
        Lines{"a.ply: byte " + std::to_string(body + 48) + ": vertex 2 is not finite",  // 1e300
              "a.ply: byte " + std::to_string(body + 72) + ": face dropped: its vertex 2 is not finite",
              "a.ply: no faces, only 3 vertices"});
  CHECK(got.scene.positions[0].x == 1.0F);
  CHECK(got.scene.positions[0].y == 0x1.000002p0F);
  CHECK(std::bit_cast<std::uint32_t>(got.scene.positions[0].z) == 0x80000000U);
  CHECK(got.scene.positions[1] == glm::vec3(0, 0, 1));
}

TEST_CASE("scene: the first byte of a binary PLY body may look like a line end") {
  const std::string elements =
      "element vertex 3\nproperty uchar x\nproperty uchar y\nproperty uchar z\nelement face 1\n" + face;
  const std::string body = std::string("\n\n\r\r\n\n\n\r\n") + "\3" + bytes_of(0) + bytes_of(1) + bytes_of(2);
  for (const std::string& end : {std::string("\n"), std::string("\r\n"), std::string("\r")}) {
    std::string header = "ply\nformat binary_little_endian 1.0\n" + elements + "end_header\n";
    if (end != "\n") {
      for (std::size_t at = header.find('\n'); at != std::string::npos;
           at = header.find('\n', at + end.size())) {
        header.replace(at, 1, end);
      }
    }
    const Reading got = read_text("a.ply", header + body);
    CHECK(got.error.empty());
    REQUIRE(got.scene.positions.size() == 3);
    CHECK(got.scene.positions[0] == glm::vec3(10.0F, 10.0F, 13.0F));
    CHECK(got.scene.triangles.size() == 1);
  }
}

TEST_CASE("scene: PLY strips become triangles that turn alike, and -1 begins anew") {
  const Reading got =
      read_text("a.ply", ascii(vertex4 + "element tristrips 1\nproperty list int int vertex_indices\n",
                               square + "8 0 1 2 3 -1 3 2 1\n"));
  CHECK(corners(got.scene) == Corners{{0, 1, 2}, {2, 1, 3}, {3, 2, 1}});
  CHECK(faces(got.scene) == Faces{0, 1, 2});
}

TEST_CASE("scene: PLY faces may come before their vertices") {
  const Reading got =
      read_text("a.ply", ascii("element face 2\n" + face + vertex4, "3 0 1 2\n3 0 2 3\n" + square));
  CHECK(got.error.empty());
  CHECK(corners(got.scene) == Corners{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("scene: blanks and long rows in ASCII PLY do no harm") {
  const Reading got =
      read_text("a.ply",
                "ply\nformat   ascii 1.0\t\n element vertex\t3\nproperty float x\nproperty   float y\n"
                "property float z\n\telement face 1\nproperty list uchar int vertex_indices \nend_header \n"
                " 0 0\n 0\n1 0 0\n\n0 1 0\n3 0\n1 2\n");
  CHECK(got.error.empty());
  CHECK(corners(got.scene) == Corners{{0, 1, 2}});
}

TEST_CASE("scene: PLY without faces loads and says so") {
  CHECK(read_text("a.ply", ascii("", "")).warnings == Lines{"a.ply: no faces"});
  CHECK(read_text("a.ply", ascii(vertex4 + "element face 0\n" + face, square)).warnings ==
        Lines{"a.ply: no faces, only 4 vertices"});
}

TEST_CASE("scene: PLY faces with bad indices or too few corners are dropped and said") {
  const Reading got = read_text("a.ply", ascii(vertex3 + "element face 4\n" + face,
                                               "0 0 0\n1 0 0\n0 nan 0\n3 0 1 3\n2 0 1\n3 -1 0 1\n3 0 0 1\n"));
  CHECK(got.warnings == Lines{"a.ply:12: vertex 2 is not finite",
                              "a.ply:13: vertex index 3 out of range (3 vertices): face dropped",
                              "a.ply:14: face with 2 corners dropped",
                              "a.ply:15: vertex index -1 out of range (3 vertices): face dropped",
                              "a.ply:16: face repeats a corner",
                              "a.ply: 1 triangle has no area and will cover nothing"});
  CHECK(corners(got.scene) == Corners{{0, 0, 1}});
}

TEST_CASE("scene: a PLY file that ends too soon is an error with the count") {
  const std::string elements = vertex3 + "element face 2\n" + face;
  CHECK(error_of(ascii(elements, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1")) ==
        "a.ply:14: truncated: the file ends after 1 of 2 rows of element 'face'");
  CHECK(error_of(ascii(elements, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")) ==
        "a.ply:14: truncated: the file ends after 1 of 2 rows of element 'face'");
  const std::string whole = binary(std::endian::little);
  CHECK(error_of(whole.substr(0, whole.size() - 4)) ==
        "a.ply: byte " + std::to_string(whole.size() - 16) +
            ": truncated: the file ends after 1 of 2 rows of element 'face'");
  CHECK(error_of("ply\nformat ascii 1.0\nelement vertex 3\n") ==
        "a.ply: truncated: the header has no end_header");
}

TEST_CASE("scene: PLY counts beyond the file's size are refused before anything is made") {
  CHECK(error_of(ascii("element vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\n",
                       "0 0 0\n")) ==
        "a.ply:3: truncated: 4000000000 rows of element 'vertex' promised, but only 6 bytes left");
  std::string binary_text =
      "ply\nformat binary_big_endian 1.0\nelement face 4000000000\n" + face + "end_header\n\3";
  CHECK(error_of(binary_text) ==
        "a.ply:3: truncated: 4000000000 rows of element 'face' promised, but only 1 byte left");
  binary_text.replace(binary_text.find("4000000000"), 10, "1");
  binary_text.replace(binary_text.find("uchar"), 5, "uint");
  CHECK(error_of(binary_text + "\xFF\xFF\xFF\xFF") ==
        "a.ply: byte " + std::to_string(binary_text.size() - 1) +
            ": truncated: the file ends after 0 of 1 rows of element 'face'");
  // Rows without properties take no bytes at all: they are not walked through.
  CHECK(error_of(ascii("element nothing 999999999999999999\n" + vertex3 + "element face 1\n" + face,
                       "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"))
            .empty());
}

TEST_CASE("scene: broken PLY headers are errors with the line") {
  CHECK(error_of(ascii("element vertex 3\nproperty float x\nproperty float y\n", "")) ==
        "a.ply:3: element vertex needs the properties x, y and z");
  CHECK(error_of(ascii(vertex3 + "element face 1\nproperty list uchar int corners\n", square)) ==
        "a.ply:7: element 'face' needs a list vertex_indices or vertex_index");
  CHECK(error_of(ascii("element face 1\nproperty list uchar float vertex_index\n", "")) ==
        "a.ply:3: vertex indices must be of a whole type");
  CHECK(error_of(ascii("element face 1\nproperty list float int vertex_index\n", "")) ==
        "a.ply:4: the length of a list must be of a whole type");
  CHECK(error_of(ascii("element face -1\n", "")) == "a.ply:3: an element needs a name and a number of rows");
  CHECK(error_of(ascii("property float x\n", "")) == "a.ply:3: property before any element");
  CHECK(error_of(ascii("element a 1\nproperty float128 x\n", "")) == "a.ply:4: unknown type 'float128'");
  CHECK(error_of(ascii("elephant\n", "")) == "a.ply:3: unknown word 'elephant' in the header");
  CHECK(error_of("ply\nformat binary 1.0\nend_header\n") == "a.ply:2: unknown format 'binary'");
  CHECK(error_of("ply\nend_header\n") == "a.ply: the header names no format");
  CHECK(error_of("play\nformat ascii 1.0\nend_header\n") ==
        "a.ply: not a PLY file: it does not begin with 'ply'");
}

TEST_CASE("scene: ASCII PLY rows that do not fit the header are errors, not shifted values") {
  const std::string elements = vertex3 + "element face 1\n" + face;
  CHECK(error_of(ascii(elements, "0 0 0\n1 0\n0 1 0 0\n3 0 1 2\n")) ==
        "a.ply:11: row has fewer values than the header says");
  CHECK(error_of(ascii(elements, "0 0 0\n1 0 0\n0 1 0\n3.5 0 1 2\n")) ==
        "a.ply:13: '3.5' is not a whole number");
  CHECK(error_of(ascii(elements, "0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n")) ==
        "a.ply:13: list 'vertex_indices' has a negative length");
  CHECK(read_text("a.ply", ascii(elements, "0 0 0 8\n1 0 0\n0 1 0\n3 0 1 2\nmore\n")).warnings ==
        Lines{"a.ply:10: row has more values than the header says: ignored",
              "a.ply: what follows the last row is ignored"});
  // The list hangs on the vertices by mistake: there is nothing to read it from.
  CHECK(error_of(ascii(vertex3 + face, "0 0 0\n1 0 0\n0 1 0\n")).find("a.ply:") == 0);
}
