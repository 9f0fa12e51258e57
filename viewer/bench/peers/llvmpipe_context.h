#pragma once

#include <GL/osmesa.h>

// After osmesa.h, which brings gl.h.
#include <GL/glext.h>

#include <array>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "view/view.h"

namespace hsr::bench {

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
  PFNGLBINDBUFFERBASEPROC bind_buffer_base = function<PFNGLBINDBUFFERBASEPROC>("glBindBufferBase");
  PFNGLCLEARBUFFERDATAPROC clear_buffer = function<PFNGLCLEARBUFFERDATAPROC>("glClearBufferData");
  PFNGLGETBUFFERSUBDATAPROC read_buffer = function<PFNGLGETBUFFERSUBDATAPROC>("glGetBufferSubData");
  PFNGLMEMORYBARRIERPROC memory_barrier = function<PFNGLMEMORYBARRIERPROC>("glMemoryBarrier");
  PFNGLDISPATCHCOMPUTEPROC dispatch = function<PFNGLDISPATCHCOMPUTEPROC>("glDispatchCompute");
  PFNGLUNIFORM1IPROC uniform = function<PFNGLUNIFORM1IPROC>("glUniform1i");
};

/// The vertices of a view, through its matrix.
inline constexpr const char* view_vertex_shader = R"(#version 430 core
layout(location = 0) in vec3 position;
uniform mat4 clip_from_world;
void main() { gl_Position = clip_from_world * vec4(position, 1.0); }
)";

/// Mesa's llvmpipe, with the triangles of a view uploaded. LP_NUM_THREADS must be set before the process
/// starts (0: everything on the calling thread). Throws std::runtime_error with a reason where it cannot.
class Llvmpipe {
 public:
  explicit Llvmpipe(const View& view);
  ~Llvmpipe() { OSMesaDestroyContext(context_); }
  Llvmpipe(const Llvmpipe&) = delete;
  Llvmpipe& operator=(const Llvmpipe&) = delete;

  const Functions& gl() const { return *gl_; }
  /// A program of shaders by their kinds.
  GLuint program(std::initializer_list<std::pair<GLenum, const char*>> shaders) const;
  /// Makes the view's matrix that of a program with the vertex shader above, and uses it.
  void use_with_matrix(GLuint program) const;
  /// Draws every triangle.
  void draw() const { glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr); }

 private:
  void make_context();
  void upload();

  View view_;
  OSMesaContext context_ = nullptr;
  std::array<unsigned char, 64> unused_{};  // OSMesa wants a picture of its own
  std::unique_ptr<Functions> gl_;
  GLsizei count_ = 0;
};

}  // namespace hsr::bench
