// Mesa's llvmpipe, OpenGL on the processor: a z-buffer with 32-bit depth, its shaders compiled to vector
// instructions. LP_NUM_THREADS must be set before it starts (0: everything on the calling thread).
//
//   zbuffer     ids from gl_PrimitiveID into an integer attachment, depth into DEPTH_COMPONENT32F

#include <GL/osmesa.h>

// After osmesa.h, which brings gl.h.
#include <GL/glext.h>

#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/peers/peer.h"

namespace hsr::bench {
namespace {

/// An OpenGL function, found by its name.
template <class Function>
Function function(const char* name) {
  const auto found = reinterpret_cast<Function>(OSMesaGetProcAddress(name));
  if (found == nullptr) throw std::runtime_error(std::string("OpenGL has no ") + name);
  return found;
}

/// The functions that are younger than OpenGL 1.1.
struct Functions {
  PFNGLCREATESHADERPROC create_shader = function<PFNGLCREATESHADERPROC>("glCreateShader");
  PFNGLSHADERSOURCEPROC shader_source = function<PFNGLSHADERSOURCEPROC>("glShaderSource");
  PFNGLCOMPILESHADERPROC compile_shader = function<PFNGLCOMPILESHADERPROC>("glCompileShader");
  PFNGLCREATEPROGRAMPROC create_program = function<PFNGLCREATEPROGRAMPROC>("glCreateProgram");
  PFNGLATTACHSHADERPROC attach_shader = function<PFNGLATTACHSHADERPROC>("glAttachShader");
  PFNGLLINKPROGRAMPROC link_program = function<PFNGLLINKPROGRAMPROC>("glLinkProgram");
  PFNGLGETPROGRAMIVPROC get_program = function<PFNGLGETPROGRAMIVPROC>("glGetProgramiv");
  PFNGLUSEPROGRAMPROC use_program = function<PFNGLUSEPROGRAMPROC>("glUseProgram");
  PFNGLGETUNIFORMLOCATIONPROC uniform_location =
      function<PFNGLGETUNIFORMLOCATIONPROC>("glGetUniformLocation");
  PFNGLUNIFORMMATRIX4FVPROC uniform_matrix = function<PFNGLUNIFORMMATRIX4FVPROC>("glUniformMatrix4fv");
  PFNGLGENVERTEXARRAYSPROC make_vertex_arrays = function<PFNGLGENVERTEXARRAYSPROC>("glGenVertexArrays");
  PFNGLBINDVERTEXARRAYPROC bind_vertex_array = function<PFNGLBINDVERTEXARRAYPROC>("glBindVertexArray");
  PFNGLGENBUFFERSPROC make_buffers = function<PFNGLGENBUFFERSPROC>("glGenBuffers");
  PFNGLBINDBUFFERPROC bind_buffer = function<PFNGLBINDBUFFERPROC>("glBindBuffer");
  PFNGLBUFFERDATAPROC buffer_data = function<PFNGLBUFFERDATAPROC>("glBufferData");
  PFNGLVERTEXATTRIBPOINTERPROC attribute = function<PFNGLVERTEXATTRIBPOINTERPROC>("glVertexAttribPointer");
  PFNGLENABLEVERTEXATTRIBARRAYPROC enable_attribute =
      function<PFNGLENABLEVERTEXATTRIBARRAYPROC>("glEnableVertexAttribArray");
  PFNGLGENFRAMEBUFFERSPROC make_framebuffers = function<PFNGLGENFRAMEBUFFERSPROC>("glGenFramebuffers");
  PFNGLBINDFRAMEBUFFERPROC bind_framebuffer = function<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer");
  PFNGLGENRENDERBUFFERSPROC make_renderbuffers = function<PFNGLGENRENDERBUFFERSPROC>("glGenRenderbuffers");
  PFNGLBINDRENDERBUFFERPROC bind_renderbuffer = function<PFNGLBINDRENDERBUFFERPROC>("glBindRenderbuffer");
  PFNGLRENDERBUFFERSTORAGEPROC renderbuffer_storage =
      function<PFNGLRENDERBUFFERSTORAGEPROC>("glRenderbufferStorage");
  PFNGLFRAMEBUFFERRENDERBUFFERPROC attach_renderbuffer =
      function<PFNGLFRAMEBUFFERRENDERBUFFERPROC>("glFramebufferRenderbuffer");
  PFNGLCHECKFRAMEBUFFERSTATUSPROC framebuffer_status =
      function<PFNGLCHECKFRAMEBUFFERSTATUSPROC>("glCheckFramebufferStatus");
  PFNGLCLEARBUFFERUIVPROC clear_ids = function<PFNGLCLEARBUFFERUIVPROC>("glClearBufferuiv");
};

constexpr const char* vertex_shader = R"(#version 430 core
layout(location = 0) in vec3 position;
uniform mat4 clip_from_world;
void main() { gl_Position = clip_from_world * vec4(position, 1.0); }
)";

constexpr const char* fragment_shader = R"(#version 430 core
layout(location = 0) out uint id;
void main() { id = uint(gl_PrimitiveID); }
)";

class LlvmpipePeer {
 public:
  explicit LlvmpipePeer(const PeerTask& task) : view_(task.view) {
    if (task.variant != "zbuffer") throw std::runtime_error("no variant is called " + task.variant);
    make_context();
    gl_ = std::make_unique<Functions>();
    make_program();
    make_framebuffer();
    upload();
    run();  // compiles what is compiled at the first use
  }
  ~LlvmpipePeer() { OSMesaDestroyContext(context_); }
  LlvmpipePeer(const LlvmpipePeer&) = delete;
  LlvmpipePeer& operator=(const LlvmpipePeer&) = delete;

  void run() {
    const std::array<GLuint, 4> nothing = {background_id, 0, 0, 0};
    gl_->clear_ids(GL_COLOR, 0, nothing.data());
    glClear(GL_DEPTH_BUFFER_BIT);
    glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
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
  void make_context() {
    const std::array<int, 11> wanted = {OSMESA_FORMAT,
                                        OSMESA_RGBA,
                                        OSMESA_PROFILE,
                                        OSMESA_CORE_PROFILE,
                                        OSMESA_CONTEXT_MAJOR_VERSION,
                                        4,
                                        OSMESA_CONTEXT_MINOR_VERSION,
                                        3,
                                        OSMESA_DEPTH_BITS,
                                        0,
                                        0};
    context_ = OSMesaCreateContextAttribs(wanted.data(), nullptr);
    if (context_ == nullptr ||
        OSMesaMakeCurrent(context_, unused_.data(), GL_UNSIGNED_BYTE, 4, 4) == GL_FALSE) {
      throw std::runtime_error("OSMesa makes no context of OpenGL 4.3");
    }
    const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    if (renderer.find("llvmpipe") == std::string::npos) throw std::runtime_error("OSMesa runs " + renderer);
  }

  void make_program() {
    const GLuint program = gl_->create_program();
    for (const auto& [kind, text] :
         {std::pair(GL_VERTEX_SHADER, vertex_shader), std::pair(GL_FRAGMENT_SHADER, fragment_shader)}) {
      const GLuint shader = gl_->create_shader(static_cast<GLenum>(kind));
      gl_->shader_source(shader, 1, &text, nullptr);
      gl_->compile_shader(shader);
      gl_->attach_shader(program, shader);
    }
    gl_->link_program(program);
    GLint linked = 0;
    gl_->get_program(program, GL_LINK_STATUS, &linked);
    if (linked == 0) throw std::runtime_error("the shaders do not link");
    gl_->use_program(program);
    std::array<float, 16> matrix{};
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) {
        matrix[static_cast<std::size_t>(4 * column + row)] =
            static_cast<float>(view_.clip_from_world[column][row]);
      }
    }
    gl_->uniform_matrix(gl_->uniform_location(program, "clip_from_world"), 1, GL_FALSE, matrix.data());
  }

  void make_framebuffer() {
    GLuint framebuffer = 0;
    gl_->make_framebuffers(1, &framebuffer);
    gl_->bind_framebuffer(GL_FRAMEBUFFER, framebuffer);
    std::array<GLuint, 2> buffers{};
    gl_->make_renderbuffers(2, buffers.data());
    const auto attach = [&](GLuint buffer, GLenum format, GLenum place) {
      gl_->bind_renderbuffer(GL_RENDERBUFFER, buffer);
      gl_->renderbuffer_storage(GL_RENDERBUFFER, format, view_.width, view_.height);
      gl_->attach_renderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
    };
    attach(buffers[0], GL_R32UI, GL_COLOR_ATTACHMENT0);
    attach(buffers[1], GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
    if (gl_->framebuffer_status(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      throw std::runtime_error("the framebuffer is not complete");
    }
    glViewport(0, 0, view_.width, view_.height);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
  }

  void upload() {
    const Scene& scene = *view_.scene;
    GLuint vertex_array = 0;
    gl_->make_vertex_arrays(1, &vertex_array);
    gl_->bind_vertex_array(vertex_array);
    std::array<GLuint, 2> buffers{};
    gl_->make_buffers(2, buffers.data());
    gl_->bind_buffer(GL_ARRAY_BUFFER, buffers[0]);
    gl_->buffer_data(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(scene.positions.size() * sizeof(glm::vec3)),
                     scene.positions.data(), GL_STATIC_DRAW);
    gl_->attribute(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl_->enable_attribute(0);
    std::vector<std::uint32_t> corners;
    corners.reserve(3 * scene.triangles.size());
    for (const Triangle& triangle : scene.triangles) {
      corners.insert(corners.end(), triangle.corners.begin(), triangle.corners.end());
    }
    count_ = static_cast<GLsizei>(corners.size());
    gl_->bind_buffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    gl_->buffer_data(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(std::uint32_t)),
                     corners.data(), GL_STATIC_DRAW);
  }

  View view_;
  OSMesaContext context_ = nullptr;
  std::array<unsigned char, 64> unused_{};  // OSMesa wants a picture of its own
  std::unique_ptr<Functions> gl_;
  GLsizei count_ = 0;
};

}  // namespace
}  // namespace hsr::bench

int main(int count, char** words) {
  using namespace hsr::bench;
  return peer_main(count, words, [](const PeerTask& task) {
    const auto llvmpipe = std::make_shared<LlvmpipePeer>(task);
    return Peer{[llvmpipe] { llvmpipe->run(); },
                [llvmpipe](hsr::Frame& frame) { llvmpipe->take_picture(frame); }};
  });
}
