#include "bench/peers/peer.h"

#include <charconv>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

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

/// The numbers, with commas between, that a variable of the environment holds; none if there is no such one.
std::vector<double> numbers_of(const char* variable) {
  std::vector<double> numbers;
  const char* text = std::getenv(variable);
  while (text != nullptr && *text != '\0') {
    char* end = nullptr;
    numbers.push_back(std::strtod(text, &end));
    if (end == text || (*end != ',' && *end != '\0')) {
      throw std::runtime_error(std::string(variable) + " holds no numbers");
    }
    text = *end == ',' ? end + 1 : end;
  }
  return numbers;
}

std::optional<double> number_of(const char* variable) {
  const std::vector<double> numbers = numbers_of(variable);
  return numbers.size() == 1 ? std::optional(numbers[0]) : std::nullopt;
}

void take_camera_from_environment(Camera& camera) {
  const auto take_point = [](const char* variable, glm::dvec3& point) {
    const std::vector<double> numbers = numbers_of(variable);
    if (numbers.size() == 3) point = {numbers[0], numbers[1], numbers[2]};
  };
  take_point("HSR_EYE", camera.eye);
  take_point("HSR_TARGET", camera.target);
  take_point("HSR_UP", camera.up);
  camera.vertical_fov_degrees = number_of("HSR_FOV").value_or(camera.vertical_fov_degrees);
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
    Camera camera = scene->camera.value_or(
        framing_camera(*scene, static_cast<double>(width) / static_cast<double>(height)));
    take_camera_from_environment(camera);
    const PeerTask task = {
        words[1], whole_number(words[2]),
        make_view(*scene, camera, width, height, number_of("HSR_NEAR"), number_of("HSR_FAR"))};
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
