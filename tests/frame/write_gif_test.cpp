#include "frame/write_gif.h"

#include <doctest/doctest.h>

#include <cstdlib>

#include "frame/srgb.h"
#include "scene/errors.h"
#include "support/read_gif.h"
#include "support/temporary_folder.h"

using hsr::Frame;
using hsr::GifPalette;
using hsr::GifWriter;
using hsr::PixelBox;
using hsr::test::Gif;
using hsr::test::TemporaryFolder;

namespace {

const glm::vec3 white(1.0F);
const glm::vec3 red(1.0F, 0.0F, 0.0F);
const glm::vec3 grey(0.25F);

Gif::Color srgb(const glm::vec3& color) {
  return {hsr::srgb8_from_linear(double{color.r}), hsr::srgb8_from_linear(double{color.g}),
          hsr::srgb8_from_linear(double{color.b})};
}

void paint(Frame& frame, int i, int j, const glm::vec3& color) {
  frame.color[frame.index(i, j)] = glm::vec4(color, 1.0F);
}

}  // namespace

TEST_CASE("frame: a GIF shows each picture, with what changed alone, over the backdrop") {
  const TemporaryFolder folder;
  Frame frame(7, 5);
  GifWriter writer(folder / "a.gif", {0, 6, 0, 4}, 1, GifPalette({white, red, grey}), white);
  writer.add(frame, {}, 10);
  paint(frame, 2, 3, red);
  paint(frame, 3, 3, grey);
  writer.add(frame, {2, 3, 3, 3}, 20);
  writer.add(frame, {}, 300);  // nothing changed
  writer.finish();
  const Gif gif = hsr::test::read_gif(folder / "a.gif");
  REQUIRE(gif.pictures.size() == 3);
  CHECK(gif.width == 7);
  CHECK(gif.height == 5);
  CHECK(gif.hundredths == std::vector<int>{10, 20, 300});
  for (const Gif::Color& color : gif.pictures[0]) CHECK(color == srgb(white));
  CHECK(gif.at(1, 2, 3) == srgb(red));
  CHECK(gif.at(1, 3, 3) == srgb(grey));
  CHECK(gif.at(1, 4, 3) == srgb(white));
  CHECK(gif.pictures[2] == gif.pictures[1]);
}

TEST_CASE("frame: a GIF of a window is enlarged and cut out") {
  const TemporaryFolder folder;
  Frame frame(9, 9);
  paint(frame, 4, 6, red);
  GifWriter writer(folder / "a.gif", {3, 5, 6, 7}, 4, GifPalette({white, red}), white);
  writer.add(frame, {}, 10);
  paint(frame, 5, 7, red);
  paint(frame, 0, 0, red);  // outside
  writer.add(frame, {0, 8, 0, 8}, 10);
  writer.finish();
  const Gif gif = hsr::test::read_gif(folder / "a.gif");
  REQUIRE(gif.pictures.size() == 2);
  CHECK(gif.width == 12);
  CHECK(gif.height == 8);
  CHECK(gif.at(0, 4, 0) == srgb(red));
  CHECK(gif.at(0, 7, 3) == srgb(red));
  CHECK(gif.at(0, 8, 3) == srgb(white));
  CHECK(gif.at(0, 11, 7) == srgb(white));
  CHECK(gif.at(1, 11, 7) == srgb(red));
  CHECK(gif.at(1, 0, 0) == srgb(white));
}

TEST_CASE("frame: up to 256 colours a GIF's palette is exact, beyond it mixes") {
  std::vector<glm::vec3> colors;
  for (int k = 0; k < 256; ++k) colors.emplace_back(hsr::linear_from_srgb(k / 255.0), 0.0, 0.0);
  const GifPalette exact(colors);
  CHECK(exact.exact());
  for (const glm::vec3& color : colors) CHECK(exact.colors()[exact.place(color, 3, 4)] == srgb(color));
  colors.emplace_back(0.0F, 1.0F, 0.0F);
  const GifPalette mixed(colors);
  CHECK(!mixed.exact());
  CHECK(!GifPalette({}).exact());
  for (const glm::vec3& color : {white, glm::vec3(0.0F), grey, glm::vec3(0.1F, 0.5F, 0.8F)}) {
    std::array<int, 3> sum{};
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 4; ++i) {
        const auto& shade = mixed.colors()[mixed.place(color, i, j)];
        for (std::size_t k = 0; k < 3; ++k) sum[k] += shade[k];
      }
    }
    for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(sum[k] / 16.0 - srgb(color)[k]) <= 4.0);
  }
}

TEST_CASE("frame: a GIF that cannot be written is refused") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(GifWriter(folder / "none" / "a.gif", {0, 1, 0, 1}, 1, GifPalette({}), white),
                  hsr::InputError);
  CHECK_THROWS_AS(GifWriter(folder / "a.gif", {0, 32767, 0, 1}, 3, GifPalette({}), white), hsr::InputError);
}
