#include "frame/deep_image.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineInputFile.h>
#include <OpenEXR/ImfHeader.h>
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "exact/exact_answer.h"
#include "exact/exact_colors.h"
#include "scene/catalog.h"
#include "support/render.h"
#include "support/run_program.h"
#include "support/small_scenes.h"
#include "support/temporary_folder.h"
#include "view/shading.h"

namespace {

struct DeepSample {
  glm::vec4 color;
  float depth;
  std::uint32_t id;
};

struct DeepPixels {
  int width = 0;
  int height = 0;
  std::vector<std::vector<DeepSample>> pixels;
};

// Reads a deep image by OpenEXR's own means.
DeepPixels read_deep(const std::filesystem::path& file) {
  Imf::DeepScanLineInputFile input(file.c_str());
  REQUIRE(input.header().compression() == Imf::ZIPS_COMPRESSION);
  const Imath::Box2i window = input.header().dataWindow();
  DeepPixels deep = {window.max.x + 1, window.max.y + 1, {}};
  const auto width = static_cast<std::size_t>(deep.width);
  const std::size_t size = width * static_cast<std::size_t>(deep.height);
  std::vector<unsigned> counts(size);
  constexpr std::array<const char*, 6> names = {"R", "G", "B", "A", "Z", "id"};
  std::array<std::vector<char*>, names.size()> pointers;
  Imf::DeepFrameBuffer buffer;
  buffer.insertSampleCountSlice(Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts.data()),
                                           sizeof(unsigned), sizeof(unsigned) * width));
  for (std::size_t k = 0; k < names.size(); ++k) {
    pointers[k].resize(size);
    const Imf::PixelType type = k < 5 ? Imf::FLOAT : Imf::UINT;
    const Imf::Channel* channel = input.header().channels().findChannel(names[k]);
    REQUIRE(channel != nullptr);
    REQUIRE(channel->type == type);
    buffer.insert(names[k], Imf::DeepSlice(type, reinterpret_cast<char*>(pointers[k].data()), sizeof(char*),
                                           sizeof(char*) * width, sizeof(DeepSample)));
  }
  input.setFrameBuffer(buffer);
  input.readPixelSampleCounts(0, window.max.y);
  deep.pixels.resize(size);
  for (std::size_t pixel = 0; pixel < size; ++pixel) {
    std::vector<DeepSample>& samples = deep.pixels[pixel];
    samples.resize(counts[pixel]);
    DeepSample* first = samples.data();
    for (std::size_t k = 0; k < 4; ++k) {
      pointers[k][pixel] =
          first == nullptr ? nullptr : reinterpret_cast<char*>(&first->color[static_cast<glm::length_t>(k)]);
    }
    pointers[4][pixel] = first == nullptr ? nullptr : reinterpret_cast<char*>(&first->depth);
    pointers[5][pixel] = first == nullptr ? nullptr : reinterpret_cast<char*>(&first->id);
  }
  input.readPixels(0, window.max.y);
  return deep;
}

}  // namespace

TEST_CASE("program: a deep image holds every fragment, and flattened it is the picture") {
  const hsr::test::TemporaryFolder folder;
  for (const char* name : {"glass", "coplanar", "three-bars"}) {
    for (const char* algorithm : {"depthlist", "abuffer", "raycast"}) {
      CAPTURE(name);
      CAPTURE(algorithm);
      const hsr::test::ProgramRun run = hsr::test::run_program(
          {"render", name, "-a", algorithm, "-s", "48x40", "--deep", folder / "deep.exr"});
      REQUIRE(run.exit_code == 0);
      const DeepPixels deep = read_deep(folder / "deep.exr");
      const std::optional<hsr::Scene> scene = hsr::make_built_in_scene(name);
      REQUIRE(scene);
      const hsr::View view = hsr::make_view(*scene, *scene->camera, 48, 40);
      REQUIRE(deep.width == 48);
      REQUIRE(deep.height == 40);
      const hsr::exact::ExactAnswer exact(view, 1);
      const hsr::exact::DepthLists lists = exact.depth_lists(0, 40);
      const std::vector<glm::vec4> wanted = exact_colors(view, exact, exact.nearest(1), 1);
      double greatest = 0.0;
      for (std::size_t pixel = 0; pixel < wanted.size(); ++pixel) {
        const std::vector<DeepSample>& samples = deep.pixels[pixel];
        REQUIRE(samples.size() == lists.begin[pixel + 1] - lists.begin[pixel]);
        glm::vec4 flat(0.0F);
        for (std::size_t rank = 0; rank < samples.size(); ++rank) {
          const hsr::exact::Fragment& fragment = lists.fragments[lists.begin[pixel] + rank];
          REQUIRE(samples[rank].id == fragment.id);
          REQUIRE(std::abs(double{samples[rank].depth} / fragment.depth - 1.0) <= 0x1.001p-24);
          if (rank > 0) REQUIRE(samples[rank - 1].depth <= samples[rank].depth);
          flat = hsr::over(flat, samples[rank].color);
        }
        for (int channel = 0; channel < 4; ++channel) {
          greatest = std::max(greatest, std::abs(double{flat[channel]} - double{wanted[pixel][channel]}));
        }
      }
      CHECK(greatest < 1e-6);
    }
  }
}

TEST_CASE("program: a deep image keeps a tied fragment, without colour") {
  hsr::FragmentLists lists;
  lists.begin = {0, 0, 3};
  lists.fragments = {{7, 1.5F, false}, {9, 1.5F, true}, {2, 4.0F, false}};
  const std::vector<glm::vec4> colors(10, glm::vec4(0.25F, 0.125F, 0.5F, 0.5F));
  const hsr::test::TemporaryFolder folder;
  hsr::DeepImage image(2, 1, colors);
  image.add_rows(lists, 0, 1);
  image.write(folder / "deep.exr");
  const DeepPixels deep = read_deep(folder / "deep.exr");
  CHECK(deep.pixels[0].empty());
  REQUIRE(deep.pixels[1].size() == 3);
  const std::array<std::uint32_t, 3> ids = {7, 9, 2};
  const std::array<float, 3> alpha = {0.5F, 0.0F, 0.5F};
  for (std::size_t rank = 0; rank < 3; ++rank) {
    CHECK(deep.pixels[1][rank].id == ids[rank]);
    CHECK(deep.pixels[1][rank].color.a == alpha[rank]);
    CHECK(deep.pixels[1][rank].color.r == alpha[rank] / 2.0F);
  }
  CHECK(deep.pixels[1][1].depth == 1.5F);
}
