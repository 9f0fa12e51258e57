#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "scene/gltf_builder.h"
#include "scene/reading.h"

using hsr::test::Corners;
using hsr::test::corners;
using hsr::test::GltfBuilder;
using hsr::test::Lines;
using hsr::test::read_file;
using hsr::test::read_text;
using hsr::test::Reading;
using hsr::test::TemporaryFolder;
using nlohmann::json;

namespace {

constexpr int int8 = 5120;
constexpr int uint8 = 5121;
constexpr int int16 = 5122;
constexpr int uint16 = 5123;
constexpr int uint32 = 5125;
constexpr int float32 = 5126;

const std::vector<float> five_points{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 2, 0.1F};

/// A file with one mesh of five points and the given primitive besides its positions.
GltfBuilder file_with(json primitive) {
  GltfBuilder file;
  primitive["attributes"]["POSITION"] = file.add(five_points, float32, "VEC3");
  file.add_mesh(primitive);
  return file;
}

GltfBuilder file_with_indices(const std::vector<std::uint16_t>& indices, int mode) {
  GltfBuilder file = file_with({{"mode", mode}, {"indices", 1}});
  file.add(indices, uint16, "SCALAR");
  return file;
}

Reading read(const GltfBuilder& file) { return read_text("a.gltf", file.gltf()); }

std::string error_of(const GltfBuilder& file) { return read(file).error; }

}  // namespace

TEST_CASE("scene: glTF triangles, strips and fans are read with and without indices") {
  CHECK(corners(read(file_with_indices({0, 1, 2, 2, 3, 0}, 4)).scene) == Corners{{0, 1, 2}, {2, 3, 0}});
  CHECK(corners(read(file_with_indices({0, 1, 3, 2, 4}, 5)).scene) ==
        Corners{{0, 1, 3}, {1, 2, 3}, {3, 2, 4}});
  CHECK(corners(read(file_with_indices({4, 1, 2, 3}, 6)).scene) == Corners{{1, 2, 4}, {2, 3, 4}});
  CHECK(corners(read(file_with({{"mode", 5}})).scene) == Corners{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}});
  CHECK(corners(read(file_with({{"mode", 6}})).scene) == Corners{{1, 2, 0}, {2, 3, 0}, {3, 4, 0}});
  const Reading list = read(file_with(json::object()));
  CHECK(corners(list.scene) == Corners{{0, 1, 2}});
  CHECK(list.warnings == Lines{"a.gltf: a primitive has corners left over after its triangles"});
}

TEST_CASE("scene: glTF buffers may be data, a file beside it, or part of a GLB file") {
  GltfBuilder file = file_with_indices({0, 1, 2}, 4);
  const TemporaryFolder folder;
  folder.write("inside.gltf", file.gltf());
  folder.write("my buffer.bin", file.buffer() + "more");
  folder.write("beside.gltf", file.gltf_with_buffer_file("my%20buffer.bin"));
  folder.write("whole.glb", file.glb());
  folder.write("no_ending", file.glb());
  for (const char* name : {"inside.gltf", "beside.gltf", "whole.glb", "no_ending"}) {
    CAPTURE(name);
    const Reading got = read_file(folder, name);
    CHECK(got.error.empty());
    CHECK(got.warnings.empty());
    CHECK(corners(got.scene) == Corners{{0, 1, 2}});
    REQUIRE(got.scene.positions.size() == 5);
    CHECK(got.scene.positions[4] == glm::vec3(0, 2, 0.1F));
  }
}

TEST_CASE("scene: glTF nodes move their meshes, in double, children after parents and in order") {
  GltfBuilder file = file_with_indices({0, 1, 2}, 4);
  const double half = std::sqrt(0.5);
  file.json["nodes"] = {{{"children", {2, 1}}, {"translation", {10, 0, 0}}},
                        {{"mesh", 0}, {"matrix", {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 5, 1}}},
                        {{"mesh", 0}, {"rotation", {0, 0, half, half}}, {"scale", {1, 3, 1}}}};
  file.json["scenes"] = {{{"nodes", {0}}}};
  const Reading got = read(file);
  REQUIRE(got.scene.positions.size() == 10);
  CHECK(std::abs(got.scene.positions[2].x - 7.0F) < 1e-6F);  // (1, 1, 0): stretched, turned, moved
  CHECK(std::abs(got.scene.positions[2].y - 1.0F) < 1e-6F);
  CHECK(got.scene.positions[7] == glm::vec3(12, 2, 5));
  CHECK(corners(got.scene) == Corners{{0, 1, 2}, {5, 6, 7}});
}

TEST_CASE("scene: a glTF position is rounded to float32 once, after all transforms") {
  GltfBuilder file = file_with_indices({0, 1, 2}, 4);
  // 1 + 2^-24 + 2^-40 rounds up; rounded between the nodes it would become 1 and stay.
  file.json["nodes"] = {{{"children", {1}}, {"translation", {std::ldexp(1.0, -40), 0, 0}}},
                        {{"mesh", 0}, {"translation", {std::ldexp(1.0, -24), 0, 0}}}};
  file.json["scenes"] = {{{"nodes", {0}}}};
  CHECK(read(file).scene.positions[1].x == 0x1.000002p0F);
}

TEST_CASE("scene: a glTF node that mirrors keeps its front in front") {
  GltfBuilder file = file_with_indices({0, 1, 2}, 4);
  file.json["nodes"][0]["scale"] = {-1, 1, 1};
  CHECK(corners(read(file).scene) == Corners{{0, 2, 1}});
}

TEST_CASE("scene: glTF without scenes shows every node that is nobody's child") {
  GltfBuilder file = file_with_indices({0, 1, 2}, 4);
  file.json.erase("scenes");
  file.json["nodes"] = {{{"mesh", 0}}, {{"children", {0}}}, {{"mesh", 0}}};
  CHECK(read(file).scene.triangles.size() == 2);
  file.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1, 2}}}};
  CHECK(read(file).scene.triangles.size() == 1);
  file.json["scene"] = 1;
  CHECK(read(file).scene.triangles.size() == 2);
}

TEST_CASE("scene: glTF numbers of every type, strides and sparse replacements are read") {
  GltfBuilder file;
  const std::size_t positions = file.add<std::int16_t>({0, 0, 0, -5, 7, 1, 3, 2, 0}, int16, "VEC3");
  file.json["accessors"][positions]["componentType"] = int16;
  const std::size_t indices = file.add<std::uint32_t>({2, 1, 0}, uint32, "SCALAR");
  const std::size_t normalized = file.add<std::int8_t>({127, -127, -128, 0, 64, 1, 0, 0, 0}, int8, "VEC3");
  file.json["accessors"][normalized]["normalized"] = true;
  const std::size_t few = file.add<std::uint8_t>({0, 1, 2}, uint8, "SCALAR");
  file.add_mesh({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
  file.add_mesh({{"attributes", {{"POSITION", normalized}}}, {"indices", few}});
  // Points 24 bytes apart, four bytes into a view.
  file.add<float>({9, 1, 2, 3, 0, 0, 0, 4, 5, 6, 0, 0, 0, 7, 8, 8}, float32, "SCALAR");
  file.json["bufferViews"].back()["byteStride"] = 24;
  file.json["accessors"].back() = {{"bufferView", file.json["bufferViews"].size() - 1},
                                   {"byteOffset", 4},
                                   {"componentType", float32},
                                   {"count", 3},
                                   {"type", "VEC3"}};
  file.add_mesh({{"attributes", {{"POSITION", file.json["accessors"].size() - 1}}}});
  // Zeros, but for elements 1 and 2.
  file.add<std::uint16_t>({1, 2}, uint16, "SCALAR");
  file.add<float>({1, 0, 0, 0, 1, 0.5F}, float32, "VEC3");
  const std::size_t views = file.json["bufferViews"].size();
  file.json["accessors"].push_back({{"componentType", float32},
                                    {"count", 3},
                                    {"type", "VEC3"},
                                    {"sparse",
                                     {{"count", 2},
                                      {"indices", {{"bufferView", views - 2}, {"componentType", uint16}}},
                                      {"values", {{"bufferView", views - 1}}}}}});
  file.add_mesh({{"attributes", {{"POSITION", file.json["accessors"].size() - 1}}}});

  const Reading got = read(file);
  CHECK(got.error.empty());
  CHECK(got.warnings.empty());
  REQUIRE(got.scene.positions.size() == 12);
  CHECK(got.scene.positions[1] == glm::vec3(-5, 7, 1));
  CHECK(got.scene.positions[3] == glm::vec3(1, -1, -1));
  CHECK(got.scene.positions[4] ==
        glm::vec3(0, static_cast<float>(64.0 / 127.0), static_cast<float>(1.0 / 127.0)));
  CHECK(got.scene.positions[7] == glm::vec3(4, 5, 6));
  CHECK(got.scene.positions[9] == glm::vec3(0));
  CHECK(got.scene.positions[11] == glm::vec3(0, 1, 0.5F));
  CHECK(corners(got.scene)[0] == std::array<std::uint32_t, 3>{2, 1, 0});
}

TEST_CASE("scene: glTF primitives of one mesh share their positions") {
  GltfBuilder file = file_with_indices({0, 1, 2}, 4);
  file.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 6}});
  CHECK(read(file).scene.positions.size() == 5);
}

TEST_CASE("scene: glTF base colours become materials, with opacity as alphaMode says") {
  GltfBuilder file = file_with_indices({0, 1, 2}, 4);
  const auto material = [](const char* name, double alpha) {
    return json{{"name", name}, {"pbrMetallicRoughness", {{"baseColorFactor", {1.0, 0.5, 0.25, alpha}}}}};
  };
  json blend = material("blend", 0.25);
  blend["alphaMode"] = "BLEND";
  json mask = material("mask", 0.25);
  mask["alphaMode"] = "MASK";
  file.json["materials"] = {json::object(), mask, blend, material("opaque", 0.25)};
  file.json["meshes"][0]["primitives"][0]["material"] = 2;
  for (const int used : {3, 1, 2, 0}) {
    file.add_mesh({{"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"material", used}});
  }
  file.add_mesh({{"attributes", {{"POSITION", 0}}}, {"indices", 1}});
  const Reading got = read(file);
  CHECK(got.error.empty());
  REQUIRE(got.scene.materials.size() == 4);
  CHECK(got.scene.materials[0].name == "blend");
  CHECK(got.scene.materials[0].color == glm::vec3(1.0F, 0.5F, 0.25F));
  CHECK(got.scene.materials[0].opacity == 0.25F);
  CHECK(got.scene.materials[1].opacity == 1.0F);
  CHECK(got.scene.materials[2].opacity == 0.0F);
  CHECK(got.scene.materials[3].color == glm::vec3(1.0F));
  CHECK(got.scene.materials[3].name == "material_0");
  REQUIRE(got.scene.triangles.size() == 6);
  CHECK(got.scene.triangles[3].material == 0);
  CHECK(got.scene.triangles[5].material == hsr::no_material);
}

TEST_CASE("scene: the first perspective camera of glTF is the scene's, others are passed over") {
  GltfBuilder file = file_with_indices({0, 1, 2}, 4);
  file.json["cameras"] = {{{"type", "orthographic"}, {"orthographic", {{"xmag", 1}}}},
                          {{"type", "perspective"}, {"perspective", {{"yfov", std::numbers::pi / 3}}}},
                          {{"type", "perspective"}, {"perspective", {{"yfov", 4.0}}}}};
  file.json["nodes"].push_back({{"camera", 0}});
  file.json["nodes"].push_back({{"camera", 2}});
  file.json["nodes"].push_back({{"camera", 1}, {"translation", {1, 2, 30}}, {"scale", {2, 2, 2}}});
  file.json["nodes"].push_back({{"camera", 1}});
  file.json["scenes"][0]["nodes"] = {0, 1, 2, 3, 4};
  const Reading got = read(file);
  REQUIRE(got.scene.camera);
  CHECK(got.scene.camera->eye == glm::dvec3(1, 2, 30));
  CHECK(got.scene.camera->target.x == 1);
  CHECK(got.scene.camera->target.z < 1.0);  // along -z to the depth of the mesh
  CHECK(got.scene.camera->up.y > 0);
  CHECK(std::abs(got.scene.camera->vertical_fov_degrees - 60.0) < 1e-12);
  CHECK(got.warnings == Lines{"a.gltf: an orthographic camera is passed over",
                              "a.gltf: a camera that cannot be used is passed over"});
}

TEST_CASE("scene: what glTF has and a scene has not is said") {
  GltfBuilder file = file_with_indices({0, 1, 2}, 4);
  file.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  file.json["meshes"][0]["primitives"][0]["targets"] = json::array({{{"POSITION", 0}}});
  file.json["nodes"][0]["skin"] = 0;
  file.add_mesh({{"attributes", {{"POSITION", 0}}}, {"mode", 1}});
  file.add_mesh({{"attributes", {{"NORMAL", 0}}}});
  CHECK(read(file).warnings ==
        Lines{"a.gltf: textures are left out: only base colour factors are used",
              "a.gltf: morph targets are left out: meshes keep their base shape",
              "a.gltf: skins are left out: meshes keep the shape and place of their nodes",
              "a.gltf: points and lines are left out", "a.gltf: a primitive without POSITION is left out"});
  file = file_with_indices({0, 1, 9, 0, 1, 2}, 4);
  CHECK(read(file).warnings == Lines{"a.gltf: vertex index 9 out of range of its primitive: face dropped"});
}

TEST_CASE("scene: glTF that requires what is not supported is an error that names it") {
  GltfBuilder file = file_with_indices({0, 1, 2}, 4);
  file.json["extensionsRequired"] = {"KHR_draco_mesh_compression", "KHR_mesh_quantization", "EXT_x"};
  CHECK(error_of(file) ==
        "a.gltf: the file requires what is not supported: 'KHR_draco_mesh_compression', 'EXT_x'");
  file = file_with_indices({0, 1, 2}, 4);
  file.json["asset"]["version"] = "1.0";
  CHECK(error_of(file) == "a.gltf: the file is of glTF version '1.0': only 2.0 is supported");
  CHECK(read_text("a.gltf", "{}").error == "a.gltf: the file is not glTF: it has no asset.version");
}

TEST_CASE("scene: broken glTF JSON is an error with byte or path") {
  CHECK(read_text("a.gltf", "{\"asset\": }").error == "a.gltf: byte 11: broken JSON");
  CHECK(read_text("a.gltf", "{\"asset\":" + std::string(100000, '[')).error ==
        "a.gltf: JSON nested more than 100 deep");
  const auto with = [](const char* key, const json& value) {
    GltfBuilder file = file_with_indices({0, 1, 2}, 4);
    file.json[json::json_pointer(key)] = value;
    return error_of(file);
  };
  CHECK(with("/meshes/0/primitives/0/indices", 9) ==
        "a.gltf: meshes[0].primitives[0].indices is 9, but there are only 2 accessors");
  CHECK(with("/meshes/0/primitives/0/indices", -1) ==
        "a.gltf: meshes[0].primitives[0].indices must be a whole number from 0");
  CHECK(with("/meshes/0/primitives/0/indices", 0) == "a.gltf: accessors[0] must be SCALAR");
  CHECK(with("/meshes/0/primitives/0/mode", 7) == "a.gltf: a primitive has the unknown mode 7");
  CHECK(with("/meshes/0/primitives", 5) == "a.gltf: meshes[0].primitives must be an array");
  CHECK(with("/nodes/0", 5) == "a.gltf: nodes[0] must be an object");
  CHECK(with("/nodes/0/matrix", {1, 2, 3}) == "a.gltf: nodes[0].matrix must be 16 numbers");
  CHECK(with("/nodes/0/scale", {1, 2, "x"}) == "a.gltf: nodes[0].scale must be 3 numbers");
  CHECK(with("/nodes/0/children", {0}) == "a.gltf: nodes[0] is reached twice: nodes must form a tree");
  CHECK(with("/accessors/0/type", "VEC9") == "a.gltf: accessors[0] has an unknown type 'VEC9'");
  CHECK(with("/accessors/0/componentType", 5124) == "a.gltf: accessors[0] has an unknown componentType 5124");
  CHECK(with("/accessors/1/componentType", float32) ==
        "a.gltf: accessors[1]: indices must be of a whole type");
  CHECK(with("/bufferViews/0/byteStride", 4) ==
        "a.gltf: bufferViews[0]: byteStride is smaller than an element");
  CHECK(with("/scene", 1) == "a.gltf: scene is 1, but there are only 1 scenes");
}

TEST_CASE("scene: glTF that points outside of its data is an error before anything is made") {
  const auto with = [](const char* key, const json& value) {
    GltfBuilder file = file_with_indices({0, 1, 2}, 4);
    file.json[json::json_pointer(key)] = value;
    return error_of(file);
  };
  CHECK(with("/accessors/0/count", 6) ==
        "a.gltf: accessors[0] has 6 elements, which are more than bufferViews[0] holds");
  CHECK(with("/accessors/0/count", 4000000000U) ==
        "a.gltf: accessors[0] has 4000000000 elements, which are more than bufferViews[0] holds");
  CHECK(with("/accessors/0/byteOffset", 9007199254740992U) ==
        "a.gltf: accessors[0] has 5 elements, which are more than bufferViews[0] holds");
  CHECK(with("/bufferViews/0/byteLength", 1000) ==
        "a.gltf: bufferViews[0] ends after the 68 bytes of its buffer");
  CHECK(with("/bufferViews/0/byteOffset", 1000) ==
        "a.gltf: bufferViews[0] ends after the 68 bytes of its buffer");
  GltfBuilder file = file_with_indices({0, 1, 2}, 4);
  file.json["accessors"][0].erase("bufferView");
  file.json["accessors"][0]["count"] = 4000000000U;
  CHECK(error_of(file) == "a.gltf: accessors[0] has no data for its 4000000000 elements");
}

TEST_CASE("scene: glTF buffers that are missing or cut off are errors") {
  const GltfBuilder file = file_with_indices({0, 1, 2}, 4);
  const auto with_uri = [&](const std::string& uri) {
    return read_text("a.gltf", file.gltf_with_buffer_file(uri)).error;
  };
  CHECK(with_uri("no.bin") == "a.gltf: buffers[0]: there is no file 'no.bin'");
  CHECK(with_uri("data:;base64,AAAA") == "a.gltf: truncated: buffers[0] has 3 of 68 bytes");
  CHECK(with_uri("data:;base64,A*AA") ==
        "a.gltf: buffers[0]: the uri 'data:;base64,A*AA' is neither a file nor data in base64");
  CHECK(with_uri("https://example.org/a.bin") ==
        "a.gltf: buffers[0]: the uri 'https://example.org/a.bin' is neither a file nor data in base64");
  const std::string glb = file.glb();
  const auto glb_error = [](const std::string& bytes) { return read_text("a.glb", bytes).error; };
  CHECK(glb_error(glb.substr(0, glb.size() - 1)).find("a.glb: truncated: the file ends after ") == 0);
  CHECK(glb_error(glb.substr(0, 10)) == "a.glb: truncated: the file ends within the GLB header");
  CHECK(glb_error(std::string("glTF\1\0\0\0\x14\0\0\0", 12)) ==
        "a.glb: byte 4: GLB version 1: only 2 is supported");
  CHECK(glb_error(std::string("glTF\2\0\0\0\x0C\0\0\0", 12)) == "a.glb: the GLB file has no JSON chunk");
  CHECK(glb_error(std::string("glTF\2\0\0\0\x14\0\0\0\xFF\xFF\xFF\xFFJSON", 20)) ==
        "a.glb: byte 12: truncated: this chunk ends after the file");
}

TEST_CASE("scene: a small glTF file that repeats its meshes without measure is refused") {
  GltfBuilder file;
  const std::vector<float> points(9000, 1.0F);
  const std::size_t positions = file.add(points, float32, "VEC3");
  file.add_mesh({{"attributes", {{"POSITION", positions}}}, {"mode", 5}});
  json nodes = json::array();
  for (int i = 0; i < 3000; ++i) {
    nodes.push_back({{"mesh", 0}});
  }
  file.json["nodes"] = nodes;
  file.json.erase("scenes");
  CHECK(error_of(file) ==
        "a.gltf: refused: repeated meshes take more than 128 MiB and more than 100 times the file");
}
