#include "scene/readers/gltf_model.h"

#include <algorithm>
#include <array>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "scene/readers/json_object.h"

namespace hsr {

using nlohmann::json;

namespace {

/// Extensions that may be required: what they change is either done here or nothing that a scene has.
constexpr std::array<std::string_view, 3> supported_extensions{
    "KHR_mesh_quantization", "KHR_texture_transform", "KHR_materials_unlit"};

class ModelParser {
 public:
  ModelParser(const Input& input, const JsonObject& root) : input_(input), root_(root) {}

  GltfModel parse() {
    check_asset();
    root_.each("buffers", [&](const JsonObject& each) { add_buffer(each); });
    root_.each("bufferViews", [&](const JsonObject& each) { add_view(each); });
    root_.each("accessors", [&](const JsonObject& each) { add_accessor(each); });
    root_.each("materials", [&](const JsonObject& each) { add_material(each); });
    root_.each("meshes", [&](const JsonObject& each) { add_mesh(each); });
    root_.each("cameras", [&](const JsonObject& each) { add_camera(each); });
    root_.each("nodes", [&](const JsonObject& /*each*/) { ++node_count_; });
    root_.each("nodes", [&](const JsonObject& each) { add_node(each); });
    choose_roots();
    return std::move(model_);
  }

 private:
  void warn(std::string_view kind, const std::string& text) {
    input_.warnings.add(kind, {}, [&] { return text; });
  }

  void check_asset() const {
    const std::string version = root_.object("asset").text("version", "");
    if (!version.starts_with("2.")) {
      root_.fail(version.empty() ? std::string("is not glTF: it has no asset.version")
                                 : "is of glTF version " + in_quotes(version) + ": only 2.0 is supported");
    }
    std::string unsupported;
    root_.each_text("extensionsRequired", [&](const std::string& name) {
      if (std::find(supported_extensions.begin(), supported_extensions.end(), name) ==
          supported_extensions.end()) {
        unsupported += (unsupported.empty() ? "" : ", ") + in_quotes(name);
      }
    });
    if (!unsupported.empty()) {
      root_.fail("requires what is not supported: " + unsupported);
    }
  }

  void add_buffer(const JsonObject& object) {
    GltfBuffer buffer;
    if (object.has("uri")) {
      buffer.uri = object.text("uri", "");
    }
    buffer.bytes = object.need_whole("byteLength");
    model_.buffers.push_back(std::move(buffer));
  }

  void add_view(const JsonObject& object) {
    GltfView view;
    view.buffer = object.need_index("buffer", model_.buffers.size(), "buffers");
    view.offset = object.whole("byteOffset", 0);
    view.bytes = object.need_whole("byteLength");
    view.stride = object.whole("byteStride", 0);
    model_.views.push_back(view);
  }

  static GltfComponent component(const JsonObject& object) {
    const std::uint64_t code = object.need_whole("componentType");
    if (code < 5120 || code > 5126 || code == 5124) {
      object.fail("has an unknown componentType " + std::to_string(code));
    }
    return static_cast<GltfComponent>(code);
  }

  GltfRun run(const JsonObject& object, GltfComponent component) const {
    return {object.need_index("bufferView", model_.views.size(), "bufferViews"),
            object.whole("byteOffset", 0), component};
  }

  void add_accessor(const JsonObject& object) {
    GltfAccessor accessor;
    accessor.component = component(object);
    accessor.count = object.need_whole("count");
    accessor.normalized = object.flag("normalized", false);
    const std::string type = object.text("type", "");
    accessor.components = type == "SCALAR"          ? 1
                          : type == "VEC2"          ? 2
                          : type == "VEC3"          ? 3
                          : type == "VEC4"          ? 4
                          : type.starts_with("MAT") ? 0
                                                    : 5;
    if (accessor.components == 5) {
      object.fail("has an unknown type " + in_quotes(type));
    }
    if (object.has("bufferView")) {
      accessor.run = run(object, accessor.component);
    }
    if (object.has("sparse")) {
      const JsonObject sparse = object.object("sparse");
      const JsonObject indices = sparse.object("indices");
      accessor.sparse = GltfSparse{sparse.need_whole("count"), run(indices, component(indices)),
                                   run(sparse.object("values"), accessor.component)};
    }
    model_.accessors.push_back(accessor);
  }

  float unit_value(double value) {
    if (!(value >= 0.0 && value <= 1.0)) {
      warn("base colour factors out of [0, 1]", "base colour factor out of [0, 1]: clamped");
    }
    return value >= 0.0 ? static_cast<float>(std::min(value, 1.0)) : 0.0F;
  }

  void add_material(const JsonObject& object) {
    Material material;
    material.name = object.text("name", "material_" + std::to_string(model_.materials.size()));
    const JsonObject surface = object.object("pbrMetallicRoughness");
    std::array<double, 4> factor{1.0, 1.0, 1.0, 1.0};
    surface.numbers("baseColorFactor", factor);
    material.color = {unit_value(factor[0]), unit_value(factor[1]), unit_value(factor[2])};
    const std::string mode = object.text("alphaMode", "OPAQUE");
    if (mode == "BLEND") {
      material.opacity = unit_value(factor[3]);
    } else if (mode == "MASK") {
      material.opacity = factor[3] < object.number("alphaCutoff", 0.5) ? 0.0F : 1.0F;
    } else if (mode != "OPAQUE") {
      object.fail("has an unknown alphaMode " + in_quotes(mode));
    }
    if (surface.has("baseColorTexture") && !std::exchange(texture_warned_, true)) {
      warn("", "textures are left out: only base colour factors are used");
    }
    model_.materials.push_back(std::move(material));
  }

  void add_mesh(const JsonObject& object) {
    GltfMesh mesh;
    object.each("primitives", [&](const JsonObject& part) {
      GltfPrimitive primitive;
      primitive.positions = part.object("attributes").index("POSITION", model_.accessors.size(), "accessors");
      primitive.indices = part.index("indices", model_.accessors.size(), "accessors");
      primitive.material = part.index("material", model_.materials.size(), "materials");
      primitive.mode = part.whole("mode", 4);
      if (part.has("targets") && !std::exchange(targets_warned_, true)) {
        warn("", "morph targets are left out: meshes keep their base shape");
      }
      mesh.primitives.push_back(primitive);
    });
    model_.meshes.push_back(std::move(mesh));
  }

  void add_camera(const JsonObject& object) {
    GltfCamera camera;
    camera.perspective = object.text("type", "") == "perspective";
    camera.vertical_fov = object.object("perspective").number("yfov", 0.0);
    model_.cameras.push_back(camera);
  }

  void add_node(const JsonObject& object) {
    GltfNode node;
    node.parent_from_node = transform(object);
    node.mesh = object.index("mesh", model_.meshes.size(), "meshes");
    node.camera = object.index("camera", model_.cameras.size(), "cameras");
    object.each_index("children", node_count_, "nodes",
                      [&](std::uint32_t child) { node.children.push_back(child); });
    if (object.has("skin") && !std::exchange(skin_warned_, true)) {
      warn("", "skins are left out: meshes keep the shape and place of their nodes");
    }
    model_.nodes.push_back(std::move(node));
  }

  /// The node's matrix, or translation times rotation times scale.
  static glm::dmat4 transform(const JsonObject& object) {
    std::array<double, 16> matrix{};
    if (object.numbers("matrix", matrix)) {
      return glm::make_mat4(matrix.data());
    }
    std::array<double, 3> translation{0.0, 0.0, 0.0};
    std::array<double, 4> rotation{0.0, 0.0, 0.0, 1.0};
    std::array<double, 3> scale{1.0, 1.0, 1.0};
    object.numbers("translation", translation);
    object.numbers("rotation", rotation);
    object.numbers("scale", scale);
    glm::dmat4 result = glm::mat4_cast(glm::dquat(rotation[3], rotation[0], rotation[1], rotation[2]));
    for (int k = 0; k < 3; ++k) {
      result[k] *= scale[static_cast<std::size_t>(k)];
    }
    result[3] = {translation[0], translation[1], translation[2], 1.0};
    return result;
  }

  /// The nodes of the default scene; without scenes all nodes that are nobody's child.
  void choose_roots() {
    std::vector<JsonObject> scenes;
    root_.each("scenes", [&](const JsonObject& each) { scenes.push_back(each); });
    if (!scenes.empty()) {
      const std::uint32_t chosen = root_.index("scene", scenes.size(), "scenes").value_or(0);
      scenes[chosen].each_index("nodes", node_count_, "nodes",
                                [&](std::uint32_t node) { model_.roots.push_back(node); });
      return;
    }
    std::vector<bool> is_child(node_count_, false);
    for (const GltfNode& node : model_.nodes) {
      for (const std::uint32_t child : node.children) {
        is_child[child] = true;
      }
    }
    for (std::uint32_t i = 0; i < node_count_; ++i) {
      if (!is_child[i]) {
        model_.roots.push_back(i);
      }
    }
  }

  const Input& input_;
  const JsonObject& root_;
  GltfModel model_;
  std::size_t node_count_ = 0;
  bool texture_warned_ = false;
  bool targets_warned_ = false;
  bool skin_warned_ = false;
};

}  // namespace

GltfModel parse_gltf(const Input& input, std::string_view json_text) {
  const json root = parse_json(input, json_text);
  if (!root.is_object()) {
    input.fail({}, "is not glTF: the JSON is not an object");
  }
  return ModelParser(input, JsonObject(input, root, "")).parse();
}

}  // namespace hsr
