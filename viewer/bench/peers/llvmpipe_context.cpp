#include "bench/peers/llvmpipe_context.h"

#include "scene/scene.h"

namespace hsr::bench {

Llvmpipe::Llvmpipe(const View& view) : view_(view) {
  make_context();
  gl_ = std::make_unique<Functions>();
  upload();
}

void Llvmpipe::make_context() {
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

GLuint Llvmpipe::program(std::initializer_list<std::pair<GLenum, const char*>> shaders) const {
  const GLuint program = gl_->create_program();
  for (const auto& [kind, text] : shaders) {
    const GLuint shader = gl_->create_shader(kind);
    gl_->shader_source(shader, 1, &text, nullptr);
    gl_->compile_shader(shader);
    gl_->attach_shader(program, shader);
  }
  gl_->link_program(program);
  GLint linked = 0;
  gl_->get_program(program, GL_LINK_STATUS, &linked);
  if (linked == 0) throw std::runtime_error("the shaders do not link");
  return program;
}

void Llvmpipe::use_with_matrix(GLuint program) const {
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

void Llvmpipe::upload() {
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

}  // namespace hsr::bench
