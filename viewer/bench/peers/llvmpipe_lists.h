#pragma once

#include <cstdint>
#include <vector>

#include "bench/peers/llvmpipe_context.h"
#include "bench/peers/peer.h"

namespace hsr::bench {

/// Every surface of every pixel with llvmpipe, in order: per-pixel linked lists (Yang, Hensley, Grün and
/// Thibieroz 2010). A fragment shader puts each fragment at the head of its pixel's list; a compute shader
/// takes each list, sorts it by depth in local memory and writes it back in order.
///
/// One buffer holds 128 MiB at most, so ids, depths and links stand in arrays of their own, and each in
/// several buffers.
class LlvmpipeLists {
 public:
  explicit LlvmpipeLists(const PeerTask& task);

  void run();
  /// The first fragment of every list.
  void take_picture(Frame& frame) const;

 private:
  void count_fragments();
  void make_buffers(std::size_t fragments);
  GLuint buffer(std::size_t bytes, GLuint place) const;

  View view_;
  Llvmpipe mesa_;
  GLuint build_ = 0;
  GLuint sort_ = 0;
  GLuint heads_ = 0;    ///< per pixel
  GLuint counter_ = 0;  ///< of fragments
  GLuint nearest_ = 0;  ///< per pixel: id and depth of the first
};

}  // namespace hsr::bench
