#include "bench/peers/llvmpipe_lists.h"

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "scene/scene.h"

namespace hsr::bench {
namespace {

// Numbers in a buffer: 128 MiB of them.
constexpr std::size_t buffer_numbers = std::size_t{1} << 25U;

constexpr const char* build_shader = R"(#version 430 core
layout(std430, binding = 0) buffer Heads { uint head[]; };
layout(std430, binding = 1) buffer Counter { uint used; };
layout(std430, binding = 2) buffer Ids0 { uint id0[]; };
layout(std430, binding = 3) buffer Ids1 { uint id1[]; };
layout(std430, binding = 4) buffer Depths0 { float depth0[]; };
layout(std430, binding = 5) buffer Depths1 { float depth1[]; };
layout(std430, binding = 6) buffer Links0 { uint link0[]; };
layout(std430, binding = 7) buffer Links1 { uint link1[]; };
uniform int width;
uniform int room;
void main() {
  uint node = atomicAdd(used, 1u);
  if (node >= uint(room)) return;
  uint before = atomicExchange(head[int(gl_FragCoord.y) * width + int(gl_FragCoord.x)], node);
  uint id = uint(gl_PrimitiveID);
  float depth = 1.0 / gl_FragCoord.w;
  if (node < 33554432u) {
    id0[node] = id;
    depth0[node] = depth;
    link0[node] = before;
  } else {
    id1[node - 33554432u] = id;
    depth1[node - 33554432u] = depth;
    link1[node - 33554432u] = before;
  }
}
)";

// Of longer lists than 256 only that many are sorted: the scenes of the benchmark have none.
constexpr const char* sort_shader = R"(#version 430 core
layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer Heads { uint head[]; };
layout(std430, binding = 2) buffer Ids0 { uint id0[]; };
layout(std430, binding = 3) buffer Ids1 { uint id1[]; };
layout(std430, binding = 4) buffer Depths0 { float depth0[]; };
layout(std430, binding = 5) buffer Depths1 { float depth1[]; };
layout(std430, binding = 6) buffer Links0 { uint link0[]; };
layout(std430, binding = 7) buffer Links1 { uint link1[]; };
layout(std430, binding = 8) buffer Nearest { uvec2 nearest[]; };
uniform int pixels;
const uint none = 0xFFFFFFFFu;
uint link(uint node) { return node < 33554432u ? link0[node] : link1[node - 33554432u]; }
void main() {
  uint pixel = gl_GlobalInvocationID.x;
  if (pixel >= uint(pixels)) return;
  uint id[256];
  float depth[256];
  int count = 0;
  for (uint node = head[pixel]; node != none && count < 256; node = link(node)) {
    uint here = node < 33554432u ? id0[node] : id1[node - 33554432u];
    float far = node < 33554432u ? depth0[node] : depth1[node - 33554432u];
    int place = count++;
    while (place > 0 && (depth[place - 1] > far || (depth[place - 1] == far && id[place - 1] > here))) {
      id[place] = id[place - 1];
      depth[place] = depth[place - 1];
      --place;
    }
    id[place] = here;
    depth[place] = far;
  }
  int rank = 0;
  for (uint node = head[pixel]; node != none && rank < count; node = link(node)) {
    if (node < 33554432u) {
      id0[node] = id[rank];
      depth0[node] = depth[rank];
    } else {
      id1[node - 33554432u] = id[rank];
      depth1[node - 33554432u] = depth[rank];
    }
    ++rank;
  }
  nearest[pixel] = count > 0 ? uvec2(id[0], floatBitsToUint(depth[0])) : uvec2(none, 0u);
}
)";

}  // namespace

LlvmpipeLists::LlvmpipeLists(const PeerTask& task) : view_(task.view), mesa_(task.view) {
  const Functions& gl = mesa_.gl();
  build_ = mesa_.program({{GL_VERTEX_SHADER, view_vertex_shader}, {GL_FRAGMENT_SHADER, build_shader}});
  sort_ = mesa_.program({{GL_COMPUTE_SHADER, sort_shader}});
  // Nothing is written to it, but there must be one.
  GLuint framebuffer = 0;
  GLuint color = 0;
  gl.make_framebuffers(1, &framebuffer);
  gl.bind_framebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.make_renderbuffers(1, &color);
  gl.bind_renderbuffer(GL_RENDERBUFFER, color);
  gl.renderbuffer_storage(GL_RENDERBUFFER, GL_R8, view_.width, view_.height);
  gl.attach_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
  if (gl.framebuffer_status(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("the framebuffer is not complete");
  }
  glViewport(0, 0, view_.width, view_.height);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  count_fragments();
  run();  // compiles what is compiled at the first use
}

GLuint LlvmpipeLists::buffer(std::size_t bytes, GLuint place) const {
  GLuint made = 0;
  mesa_.gl().make_buffers(1, &made);
  mesa_.gl().bind_buffer(GL_SHADER_STORAGE_BUFFER, made);
  mesa_.gl().buffer_data(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_COPY);
  mesa_.gl().bind_buffer_base(GL_SHADER_STORAGE_BUFFER, place, made);
  return made;
}

// Draws once without room, to learn how much is needed.
void LlvmpipeLists::count_fragments() {
  const Functions& gl = mesa_.gl();
  const auto pixels = static_cast<std::size_t>(view_.width) * static_cast<std::size_t>(view_.height);
  heads_ = buffer(pixels * sizeof(GLuint), 0);
  counter_ = buffer(sizeof(GLuint), 1);
  nearest_ = buffer(2 * pixels * sizeof(GLuint), 8);
  const GLuint zero = 0;
  gl.bind_buffer(GL_SHADER_STORAGE_BUFFER, counter_);
  gl.clear_buffer(GL_SHADER_STORAGE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
  mesa_.use_with_matrix(build_);
  gl.uniform(gl.uniform_location(build_, "width"), view_.width);
  gl.uniform(gl.uniform_location(build_, "room"), 0);
  mesa_.draw();
  gl.memory_barrier(GL_ALL_BARRIER_BITS);
  glFinish();
  GLuint fragments = 0;
  gl.read_buffer(GL_SHADER_STORAGE_BUFFER, 0, sizeof(GLuint), &fragments);
  make_buffers(fragments);
  gl.uniform(gl.uniform_location(build_, "room"), static_cast<GLint>(fragments));
  gl.use_program(sort_);
  gl.uniform(gl.uniform_location(sort_, "pixels"), view_.width * view_.height);
}

void LlvmpipeLists::make_buffers(std::size_t fragments) {
  if (fragments > 2 * buffer_numbers)
    throw std::runtime_error("there are more fragments than fit its buffers");
  const std::size_t in_first = std::min(fragments, buffer_numbers);
  for (const GLuint place : {2U, 4U, 6U}) {
    buffer((in_first + 1) * sizeof(GLuint), place);
    buffer((fragments - in_first + 1) * sizeof(GLuint), place + 1);
  }
}

void LlvmpipeLists::run() {
  const Functions& gl = mesa_.gl();
  const GLuint none = background_id;
  const GLuint zero = 0;
  gl.bind_buffer(GL_SHADER_STORAGE_BUFFER, heads_);
  gl.clear_buffer(GL_SHADER_STORAGE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
  gl.bind_buffer(GL_SHADER_STORAGE_BUFFER, counter_);
  gl.clear_buffer(GL_SHADER_STORAGE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
  gl.use_program(build_);
  mesa_.draw();
  gl.memory_barrier(GL_SHADER_STORAGE_BARRIER_BIT);
  gl.use_program(sort_);
  gl.dispatch(static_cast<GLuint>((view_.width * view_.height + 63) / 64), 1, 1);
  gl.memory_barrier(GL_ALL_BARRIER_BITS);
  glFinish();
}

void LlvmpipeLists::take_picture(Frame& frame) const {
  std::vector<GLuint> nearest(2 * frame.pixel_count());
  mesa_.gl().bind_buffer(GL_SHADER_STORAGE_BUFFER, nearest_);
  mesa_.gl().read_buffer(GL_SHADER_STORAGE_BUFFER, 0,
                         static_cast<GLsizeiptr>(nearest.size() * sizeof(GLuint)), nearest.data());
  for (int j = 0; j < view_.height; ++j) {
    for (int i = 0; i < view_.width; ++i) {
      const std::size_t from = frame.index(i, view_.height - 1 - j);  // OpenGL counts rows from below
      const std::size_t to = frame.index(i, j);
      frame.id[to] = nearest[2 * from];
      if (frame.id[to] != background_id) frame.depth[to] = std::bit_cast<float>(nearest[2 * from + 1]);
    }
  }
}

}  // namespace hsr::bench
