#include "scene/read_scene.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <thread>

#include "scene/bytes.h"
#include "scene/gltf_builder.h"
#include "scene/reading.h"

using hsr::test::bytes_of;
using hsr::test::Corners;
using hsr::test::corners;
using hsr::test::GltfBuilder;
using hsr::test::Lines;
using hsr::test::read_file;
using hsr::test::read_text;
using hsr::test::Reading;
using hsr::test::TemporaryFolder;

namespace {

const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string stl =
    "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
    "endsolid\n";

std::string binary_stl() {
  std::string text = "solid" + std::string(75, ' ') + bytes_of(1U);
  for (const float value : {0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) {
    text += bytes_of(value);
  }
  return text + "ab";
}

GltfBuilder gltf() {
  GltfBuilder file;
  const std::size_t positions = file.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, 5126, "VEC3");
  file.add_mesh({{"attributes", {{"POSITION", positions}}}});
  return file;
}

std::uint32_t crc32_of(std::string_view bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int k = 0; k < 8; ++k) {
      crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
    }
  }
  return ~crc;
}

/// A gzip member that holds `bytes` as stored blocks.
std::string gzip(std::string_view bytes) {
  std::string text("\x1F\x8B\x08\0\0\0\0\0\0\x03", 10);
  std::string_view rest = bytes;
  do {
    const std::string_view block = rest.substr(0, 65535);
    rest.remove_prefix(block.size());
    text += rest.empty() ? '\1' : '\0';
    text += bytes_of(static_cast<std::uint16_t>(block.size()));
    text += bytes_of(static_cast<std::uint16_t>(~block.size()));
    text += block;
  } while (!rest.empty());
  return text + bytes_of(crc32_of(bytes)) + bytes_of(static_cast<std::uint32_t>(bytes.size()));
}

/// The start of a gzip member of nothing but blanks, 1032 times smaller: a fixed-code block with one
/// blank and then copies of 258 bytes from 1 back, two bits to each byte of the code.
std::string gzip_of_blanks(std::size_t copies) {
  std::string text("\x1F\x8B\x08\0\0\0\0\0\0\x03", 10);
  std::string bits = "110";  // last block, fixed codes (least bit first)
  bits += "01010000";        // blank: 0x30 + 0x20
  for (std::size_t i = 0; i < copies; ++i) {
    bits +=
        "11000101"
        "00000";  // length 258: code 285; distance 1: code 0
  }
  bits.resize((bits.size() + 7) / 8 * 8, '0');
  for (std::size_t i = 0; i < bits.size(); i += 8) {
    unsigned byte = 0;
    for (std::size_t k = 0; k < 8; ++k) {
      byte |= (bits[i + k] == '1' ? 1U : 0U) << k;
    }
    text += static_cast<char>(byte);
  }
  return text;
}

}  // namespace

TEST_CASE("scene: the reader is chosen by content where the ending lies or says nothing") {
  const std::string glb = gltf().glb();
  for (const std::string& content :
       {obj, off, ply, stl, binary_stl(), gltf().gltf(), glb, "\xEF\xBB\xBF" + off, "\xEF\xBB\xBF" + ply}) {
    for (const char* name :
         {"a.obj", "a.ply", "a.off", "a.stl", "a.gltf", "a.glb", "a.OBJ", "a.txt", "a", "a.obj.gz"}) {
      CAPTURE(content.substr(0, 20));
      CAPTURE(name);
      const Reading got = read_text(name, content);
      CHECK(got.error.empty());
      CHECK(corners(got.scene) == Corners{{0, 1, 2}});
    }
  }
}

TEST_CASE("scene: every format may be compressed") {
  for (const std::string& content : {obj, off, ply, stl, binary_stl(), gltf().gltf(), gltf().glb()}) {
    const Reading got = read_text("a.gz", gzip(content));
    CHECK(got.error.empty());
    CHECK(corners(got.scene) == Corners{{0, 1, 2}});
  }
  const Reading two = read_text("a.obj.gz", gzip(obj.substr(0, 20)) + gzip(obj.substr(20)));  // two members
  CHECK(corners(two.scene) == Corners{{0, 1, 2}});
}

TEST_CASE("scene: gzip data that is cut off or broken is an error, not a short mesh") {
  const std::string whole = gzip(obj);
  for (const std::size_t size : {std::size_t{2}, std::size_t{9}, std::size_t{40}, whole.size() - 1}) {
    CHECK(read_text("a.obj.gz", whole.substr(0, size)).error ==
          "a.obj.gz: gzip data is truncated after " + std::to_string(size) + " bytes");
  }
  std::string broken = whole;
  broken[30] = static_cast<char>(broken[30] + 1);
  CHECK(read_text("a.obj.gz", broken).error == "a.obj.gz: gzip data is broken near byte " +
                                                   std::to_string(whole.size() - 4) +
                                                   ": incorrect data check");
}

TEST_CASE("scene: a gzip file that inflates without measure is refused") {
  const std::string small = gzip_of_blanks(std::size_t{17} * 1024 * 1024 / 258);
  CHECK(small.size() < 200000);
  CHECK(read_text("a.obj.gz", small).error ==
        "a.obj.gz: refused: gzip data inflates to more than 100 times its size");
}

TEST_CASE("scene: files that are not there, folders and empty files are errors with the name") {
  const TemporaryFolder folder;
  folder.write("empty.obj", "");
  std::filesystem::create_directory(folder / "folder.obj");
  CHECK(read_file(folder, "no.obj").error == "no.obj: No such file or directory");
  CHECK(read_file(folder, "folder.obj").error == "folder.obj: is a folder, not a file");
  CHECK(read_file(folder, "empty.obj").error == "empty.obj: empty file");
  CHECK(read_text("a.txt", "Dear Sir,\n").error ==
        "a.txt: not a scene: neither content nor ending is that of OBJ, PLY, OFF, STL, glTF or GLB");
  CHECK(read_text("a", std::string("\0\1\2\3", 4)).error ==
        "a: not a scene: neither content nor ending is that of OBJ, PLY, OFF, STL, glTF or GLB");
}

TEST_CASE("scene: an unreadable file is an error" * doctest::skip(::geteuid() == 0)) {
  const TemporaryFolder folder;
  std::filesystem::permissions(folder.write("a.obj", obj), std::filesystem::perms::none);
  CHECK(read_file(folder, "a.obj").error == "a.obj: Permission denied");
}

TEST_CASE("scene: a scene can be read from a pipe") {
  const TemporaryFolder folder;
  const std::string pipe = (folder / "pipe").string();
  REQUIRE(std::system(("mkfifo '" + pipe + "'").c_str()) == 0);
  std::thread writer([&] { std::ofstream(pipe) << obj; });
  const Reading got = read_file(folder, "pipe");
  writer.join();
  CHECK(corners(got.scene) == Corners{{0, 1, 2}});
}

TEST_CASE("scene: reading tells its progress and stops when asked to") {
  const TemporaryFolder folder;
  std::string text;
  for (int i = 0; i < 300000; ++i) {
    text += "v 0.25 0.5 0.125\n";
  }
  folder.write("a.obj", text + "f 1 2 3\n");
  hsr::ReadReport report;
  double last = -1;
  int calls = 0;
  const hsr::Progress watch = [&](std::string_view /*stage*/, double done) {
    CHECK(done >= last);
    CHECK(done <= 1.0);
    last = done;
    ++calls;
    return true;
  };
  CHECK(hsr::read_scene(folder / "a.obj", report, watch).positions.size() == 300000);
  CHECK(calls > 4);
  CHECK(last == 1.0);
  CHECK(report.bytes == text.size() + 8);
  const hsr::Progress stop = [&](std::string_view /*stage*/, double done) { return done < 0.5; };
  CHECK_THROWS_WITH_AS(hsr::read_scene(folder / "a.obj", report, stop),
                       ((folder / "a.obj").string() + ": interrupted").c_str(), hsr::InputError);
}
