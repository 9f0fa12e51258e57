#include "frame/write_image.h"

#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "frame/srgb.h"
#include "scene/errors.h"
#include "support/read_image.h"
#include "support/temporary_folder.h"

using hsr::Frame;
using hsr::InputError;
using hsr::test::TemporaryFolder;
using Rgb = std::array<int, 3>;

namespace {

/// A frame of pseudo-random colours, depths and ids, in which no two pixels are alike.
Frame random_frame(int width, int height) {
  Frame frame(width, height);
  std::mt19937 random(20240501);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  for (std::size_t k = 0; k < frame.pixel_count(); ++k) {
    const float opacity = unit(random);
    frame.color[k] = {opacity * unit(random), opacity * unit(random), opacity * unit(random), opacity};
    frame.depth[k] = 100.0F * unit(random);
    frame.id[k] = static_cast<std::uint32_t>(random());
  }
  return frame;
}

std::size_t files_in(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

}  // namespace

TEST_CASE("frame: a PNG holds sRGB of the colours over the backdrop") {
  const TemporaryFolder folder;
  Frame frame(3, 2);
  frame.color[0] = {1.0F, 0.5F, 0.18F, 1.0F};
  frame.color[1] = {0.25F, 0.0F, 0.0F, 0.5F};
  frame.color[5] = {0.0F, 0.0F, 1.0F, 1.0F};
  hsr::write_png(frame, {0.0F, 0.36F, 1.0F}, folder / "a.png");

  const hsr::test::Picture picture = hsr::test::read_png(folder / "a.png");
  REQUIRE(picture.width == 3);
  REQUIRE(picture.height == 2);
  CHECK(picture.at(0, 0) == Rgb{255, 188, 118});
  // Half of the backdrop, (0, 0.18, 0.5), shines through the premultiplied red of 0.25.
  CHECK(picture.at(1, 0) == Rgb{137, 118, 188});
  // Background is the backdrop alone: 0.36 encodes to 0.634162, times 255 = 161.71.
  CHECK(picture.at(2, 0) == Rgb{0, 162, 255});
  CHECK(picture.at(0, 1) == Rgb{0, 162, 255});
  CHECK(picture.at(2, 1) == Rgb{0, 0, 255});
}

TEST_CASE("frame: a PNG of noise, with data chunks of every kind, reads back pixel for pixel") {
  const TemporaryFolder folder;
  // 300 x 200 pixels of noise hardly compress, so that their data takes more than two chunks.
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {9, 1}, {300, 200}}) {
    const Frame frame = random_frame(width, height);
    hsr::write_png(frame, {1.0F, 1.0F, 1.0F}, folder / "noise.png");
    const hsr::test::Picture picture = hsr::test::read_png(folder / "noise.png");
    REQUIRE(picture.width == width);
    REQUIRE(picture.height == height);
    std::size_t different = 0;
    for (std::size_t k = 0; k < frame.pixel_count(); ++k) {
      const glm::dvec4 color(frame.color[k]);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const double over_white = color[static_cast<int>(channel)] + (1.0 - color.a);
        if (picture.bytes[3 * k + channel] != hsr::srgb8_from_linear(over_white)) ++different;
      }
    }
    CHECK(different == 0);
  }
}

TEST_CASE("frame: EXR layers read back bit for bit") {
  const TemporaryFolder folder;
  Frame frame = random_frame(37, 23);
  frame.color[5] = glm::vec4(0.0F);
  frame.depth[5] = std::numeric_limits<float>::infinity();
  frame.id[5] = hsr::background_id;
  frame.depth[6] = std::numeric_limits<float>::denorm_min();
  frame.id[6] = 0;
  hsr::write_exr_layers(frame, folder / "layers.exr");

  const Frame read = hsr::test::read_exr_layers(folder / "layers.exr");
  REQUIRE(read.width == 37);
  REQUIRE(read.height == 23);
  CHECK(read.color == frame.color);
  CHECK(read.depth == frame.depth);
  CHECK(read.id == frame.id);
}

TEST_CASE("frame: an image that cannot be written is an input error and leaves nothing behind") {
  const TemporaryFolder folder;
  const Frame frame = random_frame(400, 300);
  const auto png = [&](const std::string& file) { hsr::write_png(frame, glm::vec3(0.0F), file); };
  const auto exr = [&](const std::string& file) { hsr::write_exr_layers(frame, file); };

  const std::string missing = folder / "missing" / "picture";
  CHECK_THROWS_AS(png(missing), InputError);
  CHECK_THROWS_AS(exr(missing), InputError);
  CHECK_THROWS_AS(png(folder.path()), InputError);
  CHECK_THROWS_AS(exr(folder.path()), InputError);
  if (std::filesystem::exists("/dev/full")) {  // a disk that is always full
    CHECK_THROWS_AS(png("/dev/full"), InputError);
    CHECK_THROWS_AS(exr("/dev/full"), InputError);
  }
  CHECK(files_in(folder.path()) == 0);
}

TEST_CASE("frame: writing an image replaces the file that was there and leaves no other") {
  const TemporaryFolder folder;
  folder.write("a.png", "old");
  hsr::write_png(random_frame(4, 4), glm::vec3(0.0F), folder / "a.png");
  CHECK(hsr::test::read_png(folder / "a.png").width == 4);
  CHECK(files_in(folder.path()) == 1);
}

TEST_CASE("frame: writing an image tells how far it is, up to the end") {
  const TemporaryFolder folder;
  const Frame frame = random_frame(3, 130);
  std::vector<double> told;
  const hsr::Progress progress = [&](std::string_view, double done) {
    told.push_back(done);
    return true;
  };
  hsr::write_png(frame, glm::vec3(0.0F), folder / "a.png", progress);
  CHECK(told.size() == 130);
  CHECK(told.back() == 1.0);
  told.clear();
  hsr::write_exr_layers(frame, folder / "a.exr", progress);
  CHECK(told == std::vector<double>{64.0 / 130.0, 128.0 / 130.0, 1.0});
}
