#include "bench/peers/peer.h"

#include <charconv>
#include <chrono>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string_view>

#include "scene/catalog.h"
#include "scene/read_scene.h"

namespace hsr::bench {
namespace {

int whole_number(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 1) {
    throw std::runtime_error("\"" + std::string(text) + "\" is no number from 1");
  }
  return number;
}

double milliseconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void write_picture(Frame& frame, const Peer& peer, const std::string& file) {
  peer.take_picture(frame);
  std::ofstream bytes(file, std::ios::binary);
  const auto size = static_cast<std::streamsize>(frame.pixel_count() * sizeof(std::uint32_t));
  bytes.write(reinterpret_cast<const char*>(frame.id.data()), size);
  bytes.write(reinterpret_cast<const char*>(frame.depth.data()), size);
  if (!bytes.flush()) throw std::runtime_error("cannot write " + file);
}

void serve(const Peer& peer, int width, int height) {
  Frame frame = Frame::without_colors(width, height);
  std::string line;
  while (std::getline(std::cin, line)) {
    if (line == "run") {
      std::cout << "ran " << milliseconds_of(peer.run) << std::endl;
    } else if (line.starts_with("picture ")) {
      write_picture(frame, peer, line.substr(8));
      std::cout << line << std::endl;
    } else {
      throw std::runtime_error("unknown request \"" + line + "\"");
    }
  }
}

}  // namespace

int peer_main(int count, char** words, const std::function<Peer(const PeerTask&)>& prepare) {
  try {
    if (count != 6) throw std::runtime_error("usage: VARIANT THREADS SCENE WIDTH HEIGHT");
    std::optional<Scene> scene = make_built_in_scene(words[3]);
    if (!scene) {
      ReadReport report;
      scene = read_scene(words[3], report);
    }
    const int width = whole_number(words[4]);
    const int height = whole_number(words[5]);
    const Camera camera = scene->camera.value_or(
        framing_camera(*scene, static_cast<double>(width) / static_cast<double>(height)));
    const PeerTask task = {words[1], whole_number(words[2]), make_view(*scene, camera, width, height)};
    Peer peer;
    const double prepare_ms = milliseconds_of([&] { peer = prepare(task); });
    std::cout << "ready " << prepare_ms << std::endl;
    serve(peer, width, height);
    return 0;
  } catch (const std::exception& error) {
    std::cout << "cannot " << error.what() << std::endl;
    return 1;
  }
}

}  // namespace hsr::bench
