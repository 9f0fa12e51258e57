#pragma once

#include <functional>
#include <string>

#include "frame/frame.h"
#include "view/view.h"

/// Another program that makes the same pictures as the kit. It is a process of its own, hsr-peer-NAME,
/// because it may need settings of its environment, may crash, and brings libraries that hsr itself does not
/// need.
///
/// It is started as  hsr-peer-NAME VARIANT THREADS SCENE WIDTH HEIGHT  and makes scene and view by the same
/// functions as hsr, so that they are the same bit for bit. Then it speaks in lines:
///
///   it says               ready MS            what it took to prepare; or: cannot REASON
///   it reads  run         and says  ran MS    having made the picture once
///   it reads  picture F   and says  picture F having written ids, then depths, raw
///
/// and ends when there is nothing more to read. Where its environment names a camera, that replaces the
/// scene's own: HSR_EYE, HSR_TARGET, HSR_UP (X,Y,Z) and HSR_FOV (degrees), and HSR_NEAR, HSR_FAR.
namespace hsr::bench {

/// What a peer is asked to do.
struct PeerTask {
  std::string variant;
  int threads = 1;
  View view;
};

/// What a peer can do once it is prepared.
struct Peer {
  std::function<void()> run;                 ///< timed
  std::function<void(Frame&)> take_picture;  ///< into a frame without colours
};

/// The main function of a peer. `prepare` throws std::exception with a reason if it cannot.
int peer_main(int count, char** words, const std::function<Peer(const PeerTask&)>& prepare);

}  // namespace hsr::bench
