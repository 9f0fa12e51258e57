#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/contestant.h"

namespace hsr::bench {

/// Another program, in one of its variants.
struct PeerEntry {
  std::string_view name;     ///< as in tables: "embree-coherent"
  std::string_view program;  ///< "hsr-peer-embree", beside hsr
  std::string_view variant;  ///< its first argument
  std::string_view is;       ///< one sentence
  Task task;
  bool takes_threads_from_environment;  ///< LP_NUM_THREADS
};

/// Every peer that the kit knows, installed or not.
std::span<const PeerEntry> peer_table();

/// Where a peer's program is, or an empty path if it was not built.
std::filesystem::path peer_program(const PeerEntry& peer);

/// Starts it with a scene as on the command line. `environment` may hold a camera (peers/peer.h). Throws
/// InputError if it cannot do this one.
std::unique_ptr<Contestant> start(const PeerEntry& peer, const std::string& scene, int width, int height,
                                  int threads, std::vector<std::string> environment = {});

}  // namespace hsr::bench
