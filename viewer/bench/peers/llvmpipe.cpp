// Mesa's llvmpipe, OpenGL on the processor, its shaders compiled to vector instructions.
//
//   zbuffer     a z-buffer with 32-bit depth: ids from gl_PrimitiveID into an integer attachment, depth into
//               DEPTH_COMPONENT32F
//   lists       a linked list of fragments per pixel (llvmpipe_lists.h)

#include <array>
#include <memory>
#include <stdexcept>
#include <vector>

#include "bench/peers/llvmpipe_context.h"
#include "bench/peers/llvmpipe_lists.h"
#include "bench/peers/peer.h"

namespace hsr::bench {
namespace {

constexpr const char* fragment_shader = R"(#version 430 core
layout(location = 0) out uint id;
void main() { id = uint(gl_PrimitiveID); }
)";

class LlvmpipePeer {
 public:
  explicit LlvmpipePeer(const PeerTask& task) : view_(task.view), mesa_(task.view) {
    mesa_.use_with_matrix(
        mesa_.program({{GL_VERTEX_SHADER, view_vertex_shader}, {GL_FRAGMENT_SHADER, fragment_shader}}));
    make_framebuffer();
    run();  // compiles what is compiled at the first use
  }

  void run() {
    const std::array<GLuint, 4> nothing = {background_id, 0, 0, 0};
    mesa_.gl().clear_ids(GL_COLOR, 0, nothing.data());
    glClear(GL_DEPTH_BUFFER_BIT);
    mesa_.draw();
    glFinish();
  }

  void take_picture(Frame& frame) const {
    std::vector<float> stored(frame.pixel_count());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, view_.width, view_.height, GL_RED_INTEGER, GL_UNSIGNED_INT, frame.id.data());
    glReadPixels(0, 0, view_.width, view_.height, GL_DEPTH_COMPONENT, GL_FLOAT, stored.data());
    std::vector<std::uint32_t> ids = frame.id;
    const double n = view_.near_depth;
    const double f = view_.far_depth;
    for (int j = 0; j < view_.height; ++j) {
      for (int i = 0; i < view_.width; ++i) {
        const std::size_t from = frame.index(i, view_.height - 1 - j);  // OpenGL counts rows from below
        const std::size_t to = frame.index(i, j);
        frame.id[to] = ids[from];
        const double z = 2.0 * double{stored[from]} - 1.0;
        if (ids[from] != background_id)
          frame.depth[to] = static_cast<float>(2.0 * n * f / (f + n - z * (f - n)));
      }
    }
  }

 private:
  void make_framebuffer() {
    GLuint framebuffer = 0;
    mesa_.gl().make_framebuffers(1, &framebuffer);
    mesa_.gl().bind_framebuffer(GL_FRAMEBUFFER, framebuffer);
    std::array<GLuint, 2> buffers{};
    mesa_.gl().make_renderbuffers(2, buffers.data());
    const auto attach = [&](GLuint buffer, GLenum format, GLenum place) {
      mesa_.gl().bind_renderbuffer(GL_RENDERBUFFER, buffer);
      mesa_.gl().renderbuffer_storage(GL_RENDERBUFFER, format, view_.width, view_.height);
      mesa_.gl().attach_renderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
    };
    attach(buffers[0], GL_R32UI, GL_COLOR_ATTACHMENT0);
    attach(buffers[1], GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
    if (mesa_.gl().framebuffer_status(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      throw std::runtime_error("the framebuffer is not complete");
    }
    glViewport(0, 0, view_.width, view_.height);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
  }

  View view_;
  Llvmpipe mesa_;
};

template <class AnyPeer>
Peer peer_of(const PeerTask& task) {
  const auto llvmpipe = std::make_shared<AnyPeer>(task);
  return {[llvmpipe] { llvmpipe->run(); }, [llvmpipe](Frame& frame) { llvmpipe->take_picture(frame); }};
}

}  // namespace
}  // namespace hsr::bench

int main(int count, char** words) {
  using namespace hsr::bench;
  return peer_main(count, words, [](const PeerTask& task) {
    if (task.variant == "zbuffer") return peer_of<LlvmpipePeer>(task);
    if (task.variant == "lists") return peer_of<LlvmpipeLists>(task);
    throw std::runtime_error("no variant is called " + task.variant);
  });
}
