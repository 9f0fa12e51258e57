#include "bench/peers.h"

#include <array>

#include "bench/peer_process.h"

namespace hsr::bench {

std::span<const PeerEntry> peer_table() {
  static constexpr std::array rows = {
      PeerEntry{"embree-coherent", "hsr-peer-embree", "coherent", "Embree, 16 rays at a time, best build",
                Task::nearest, false},
      PeerEntry{"embree-robust", "hsr-peer-embree", "robust", "Embree, the same with its robust flag",
                Task::nearest, false},
      PeerEntry{"embree-single", "hsr-peer-embree", "single", "Embree, ray by ray", Task::nearest, false},
      PeerEntry{"llvmpipe", "hsr-peer-llvmpipe", "zbuffer", "Mesa's llvmpipe, a z-buffer on the processor",
                Task::nearest, true},
      PeerEntry{"llvmpipe-lists", "hsr-peer-llvmpipe", "lists",
                "Mesa's llvmpipe, a linked list of fragments per pixel, sorted", Task::lists, true},
      PeerEntry{"embree-dynamic", "hsr-peer-embree", "dynamic", "Embree, low-quality build and trace",
                Task::prepare_and_nearest, false},
  };
  return rows;
}

std::filesystem::path peer_program(const PeerEntry& peer) {
  std::error_code failed;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", failed);
  if (failed) return {};
  const std::filesystem::path program = self.parent_path() / peer.program;
  return std::filesystem::exists(program, failed) ? program : std::filesystem::path();
}

std::unique_ptr<Contestant> start(const PeerEntry& peer, const std::string& scene, int width, int height,
                                  int threads, std::vector<std::string> environment) {
  // To llvmpipe, one thread is none beside the calling one.
  if (peer.takes_threads_from_environment) {
    environment.push_back("LP_NUM_THREADS=" + std::to_string(threads == 1 ? 0 : threads));
  }
  return start_peer(peer_program(peer),
                    {std::string(peer.variant), std::to_string(threads), scene, std::to_string(width),
                     std::to_string(height)},
                    environment, width, height);
}

}  // namespace hsr::bench
