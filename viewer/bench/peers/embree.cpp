// Embree, the ray tracing kernels of Intel. Its rays are floats: made from the camera, not exactly those of
// the double matrix.
//
//   coherent    16 rays at a time, told that they belong together; best build
//   robust      the same with the flag that promises watertight meshes
//   single      one ray at a time
//   dynamic     like coherent, and builds a low-quality hierarchy in every run, as for geometry that moves

#include <embree3/rtcore.h>
#include <immintrin.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include "bench/peers/peer.h"
#include "parallel.h"

namespace hsr::bench {
namespace {

/// What one asks of Embree.
struct Variant {
  bool coherent = true;
  bool single = false;
  bool robust = false;
  bool dynamic = false;
};

Variant variant_called(const std::string& name) {
  if (name == "coherent") return {};
  if (name == "robust") return {.robust = true};
  if (name == "single") return {.coherent = false, .single = true};
  if (name == "dynamic") return {.dynamic = true};
  throw std::runtime_error("no variant is called " + name);
}

/// The rays of a view's pixel centres, as direction = forward + a right + b up with unit depth.
struct Rays {
  glm::dvec3 eye;
  glm::dvec3 forward;
  glm::dvec3 right;  ///< times the half width of the picture at unit depth
  glm::dvec3 up;     ///< times its half height

  explicit Rays(const View& view) : eye(view.camera.eye) {
    forward = glm::normalize(view.camera.target - view.camera.eye);
    right = glm::normalize(glm::cross(forward, view.camera.up));
    up = glm::cross(right, forward);
    const double half_height = std::tan(glm::radians(view.camera.vertical_fov_degrees) / 2.0);
    up *= half_height;
    right *= half_height * view.width / view.height;
  }
};

class EmbreePeer {
 public:
  explicit EmbreePeer(const PeerTask& task)
      : view_(task.view), variant_(variant_called(task.variant)), threads_(task.threads), rays_(view_) {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    device_ = rtcNewDevice(("threads=" + std::to_string(threads_)).c_str());
    if (device_ == nullptr) throw std::runtime_error("Embree finds no device");
    id_.resize(static_cast<std::size_t>(view_.width) * static_cast<std::size_t>(view_.height));
    depth_.resize(id_.size());
    set_up_offsets();
    build();
  }
  ~EmbreePeer() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreePeer(const EmbreePeer&) = delete;
  EmbreePeer& operator=(const EmbreePeer&) = delete;

  void run() {
    if (variant_.dynamic) {
      rtcReleaseScene(scene_);
      build();
    }
    constexpr int tile = 16;
    const int across = (view_.width + tile - 1) / tile;
    const int down = (view_.height + tile - 1) / tile;
    parallel_for(across * down, threads_, [&](int index) {
      _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
      const int first_i = index % across * tile;
      const int first_j = index / across * tile;
      trace_tile(first_i, std::min(first_i + tile, view_.width), first_j,
                 std::min(first_j + tile, view_.height));
    });
  }

  void take_picture(Frame& frame) const {
    frame.id = id_;
    frame.depth = depth_;
  }

 private:
  void build() {
    const Scene& scene = *view_.scene;
    const RTCBuildQuality quality = variant_.dynamic ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_HIGH;
    scene_ = rtcNewScene(device_);
    rtcSetSceneBuildQuality(scene_, quality);
    int flags = RTC_SCENE_FLAG_NONE;
    if (variant_.robust) flags |= RTC_SCENE_FLAG_ROBUST;
    if (variant_.dynamic) flags |= RTC_SCENE_FLAG_DYNAMIC;
    rtcSetSceneFlags(scene_, static_cast<RTCSceneFlags>(flags));
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry, quality);
    auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), scene.positions.size()));
    for (std::size_t k = 0; k < scene.positions.size(); ++k) {
      for (int axis = 0; axis < 3; ++axis)
        positions[3 * k + static_cast<std::size_t>(axis)] = scene.positions[k][axis];
    }
    auto* corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), scene.triangles.size()));
    for (std::size_t k = 0; k < scene.triangles.size(); ++k) {
      std::ranges::copy(scene.triangles[k].corners, corners + 3 * k);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }

  void trace_tile(int first_i, int last_i, int first_j, int last_j) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    if (variant_.coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    for (int j = first_j; j < last_j; j += 4) {
      for (int i = first_i; i < last_i; i += 4) {
        if (variant_.single) {
          trace_singly(context, i, std::min(i + 4, last_i), j, std::min(j + 4, last_j));
        } else {
          trace_block(context, i, j);
        }
      }
    }
  }

  glm::vec3 direction(double i, double j) const {
    const double a = (2.0 * i + 1.0) / view_.width - 1.0;
    const double b = 1.0 - (2.0 * j + 1.0) / view_.height;
    return {rays_.forward + a * rays_.right + b * rays_.up};
  }

  // What is to be added to the direction of the first pixel of a block for each of the 16.
  void set_up_offsets() {
    for (int k = 0; k < 16; ++k) {
      const glm::dvec3 offset =
          rays_.right * (2.0 * (k % 4) / view_.width) - rays_.up * (2.0 * (k / 4) / view_.height);
      for (int axis = 0; axis < 3; ++axis) offset_[axis][k] = static_cast<float>(offset[axis]);
    }
  }

  void store(int i, int j, unsigned geometry, unsigned primitive, float depth) {
    const std::size_t pixel =
        static_cast<std::size_t>(j) * static_cast<std::size_t>(view_.width) + static_cast<std::size_t>(i);
    const bool hit = geometry != RTC_INVALID_GEOMETRY_ID;
    id_[pixel] = hit ? primitive : background_id;
    depth_[pixel] = hit ? depth : std::numeric_limits<float>::infinity();
  }

  // 4 by 4 pixels as one packet. As the direction's forward component is 1, its distance is the eye depth.
  void trace_block(RTCIntersectContext& context, int first_i, int first_j) {
    alignas(64) int valid[16];
    alignas(64) RTCRayHit16 packet;
    const glm::vec3 first = direction(first_i, first_j);
    const glm::vec3 eye(rays_.eye);
    const auto near_depth = static_cast<float>(view_.near_depth);
    const auto far_depth = static_cast<float>(view_.far_depth);
    for (int k = 0; k < 16; ++k) {
      valid[k] = first_i + k % 4 < view_.width && first_j + k / 4 < view_.height ? -1 : 0;
      packet.ray.org_x[k] = eye.x;
      packet.ray.org_y[k] = eye.y;
      packet.ray.org_z[k] = eye.z;
      packet.ray.dir_x[k] = first.x + offset_[0][k];
      packet.ray.dir_y[k] = first.y + offset_[1][k];
      packet.ray.dir_z[k] = first.z + offset_[2][k];
      packet.ray.tnear[k] = near_depth;
      packet.ray.tfar[k] = far_depth;
      packet.ray.time[k] = 0.0F;
      packet.ray.mask[k] = ~0U;
      packet.ray.flags[k] = 0;
      packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
      packet.hit.primID[k] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect16(valid, scene_, &context, &packet);
    for (int k = 0; k < 16; ++k) {
      if (valid[k] != 0)
        store(first_i + k % 4, first_j + k / 4, packet.hit.geomID[k], packet.hit.primID[k],
              packet.ray.tfar[k]);
    }
  }

  void trace_singly(RTCIntersectContext& context, int first_i, int last_i, int first_j, int last_j) {
    for (int j = first_j; j < last_j; ++j) {
      for (int i = first_i; i < last_i; ++i) {
        RTCRayHit one{};
        const glm::vec3 to = direction(i, j);
        one.ray = {static_cast<float>(rays_.eye.x),
                   static_cast<float>(rays_.eye.y),
                   static_cast<float>(rays_.eye.z),
                   static_cast<float>(view_.near_depth),
                   to.x,
                   to.y,
                   to.z,
                   0.0F,
                   static_cast<float>(view_.far_depth),
                   ~0U,
                   0,
                   0};
        one.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &one);
        store(i, j, one.hit.geomID, one.hit.primID, one.ray.tfar);
      }
    }
  }

  View view_;
  Variant variant_;
  int threads_;
  Rays rays_;
  alignas(64) float offset_[3][16] = {};
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  std::vector<std::uint32_t> id_;
  std::vector<float> depth_;
};

}  // namespace
}  // namespace hsr::bench

int main(int count, char** words) {
  using namespace hsr::bench;
  return peer_main(count, words, [](const PeerTask& task) {
    const auto embree = std::make_shared<EmbreePeer>(task);
    return Peer{[embree] { embree->run(); }, [embree](hsr::Frame& frame) { embree->take_picture(frame); }};
  });
}
