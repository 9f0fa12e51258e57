#pragma once

#include "bench/peers.h"
#include "frame/frame.h"
#include "stress/family.h"

namespace hsr::stress {

struct PeerPicture {
  Frame frame;
  double ms = 0.0;
};

/// The picture that another program makes of a problem. Throws InputError if it fails.
PeerPicture picture_of_peer(const bench::PeerEntry& peer, const Problem& problem);

}  // namespace hsr::stress
