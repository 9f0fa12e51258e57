#include "heatmaps.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <string>

#include "chart.h"
#include "text_layout.h"
#include "view/shading.h"

namespace hsr {
namespace {

using Counts = std::vector<std::uint32_t>;  // per pixel

/// "zbuffer[depth=unorm16]" as a part of a file's name: "zbuffer-depth-unorm16".
std::string file_stem(const AlgorithmSpec& spec) {
  std::string stem;
  for (const char letter : spec.text()) {
    const bool plain = std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '-';
    if (plain) stem += letter;
    if (!plain && !stem.empty() && stem.back() != '-') stem += '-';
  }
  while (!stem.empty() && stem.back() == '-') stem.pop_back();
  return stem;
}

std::string number(double value) {
  std::array<char, 40> text{};
  (void)std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

std::size_t pixel_of(const View& view, int i, int j) {
  return static_cast<std::size_t>(j) * static_cast<std::size_t>(view.width) + static_cast<std::size_t>(i);
}

constexpr glm::vec3 empty_color(0.85F);

/// Counts on a scale on which each step is a factor; pixels with none are left light.
void write_counts(const View& view, const Counts& counts, const std::string& title, const std::string& what,
                  const std::filesystem::path& file) {
  const double greatest =
      counts.empty() ? 1.0 : std::max(1.0, static_cast<double>(*std::ranges::max_element(counts)));
  const auto part = [&](double count) { return greatest > 1.0 ? std::log(count) / std::log(greatest) : 0.0; };
  Chart chart(view.width, view.height, title, [&](int i, int j) {
    const std::uint32_t count = counts[pixel_of(view, i, j)];
    return count == 0 ? empty_color : scale_color(part(static_cast<double>(count)));
  });
  chart.add_words(what);
  chart.add_scale(scale_color, "1", number(std::sqrt(greatest)), number(greatest));
  chart.add_key(empty_color, ' ', "none");
  chart.write(file);
}

Counts list_lengths(const View& view, const exact::ExactAnswer& exact, const Progress& progress) {
  Counts counts(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
  for (int j = 0; j < view.height; ++j) {
    const exact::DepthLists lists = exact.depth_lists(j, j + 1);
    for (int i = 0; i < view.width; ++i) {
      const auto column = static_cast<std::size_t>(i);
      counts[pixel_of(view, i, j)] =
          static_cast<std::uint32_t>(lists.begin[column + 1] - lists.begin[column]);
    }
    (void)report_progress(progress, "measuring the lists", static_cast<double>(j + 1) / view.height);
  }
  return counts;
}

void write_depths(const View& view, const exact::Nearest& nearest, const std::filesystem::path& file) {
  double least = view.far_depth;
  double greatest = view.near_depth;
  for (std::size_t pixel = 0; pixel < nearest.id.size(); ++pixel) {
    if (nearest.id[pixel] == background_id) continue;
    least = std::min(least, nearest.depth[pixel]);
    greatest = std::max(greatest, nearest.depth[pixel]);
  }
  const double range = greatest > least ? greatest - least : 1.0;
  Chart chart(view.width, view.height, "depth of the exact answer", [&](int i, int j) {
    const std::size_t pixel = pixel_of(view, i, j);
    if (nearest.id[pixel] == background_id) return empty_color;
    return scale_color(1.0 - (nearest.depth[pixel] - least) / range);  // what is near is bright
  });
  chart.add_words("eye depth, scene units");
  chart.add_scale(scale_color, number(greatest), number((least + greatest) / 2.0), number(least));
  chart.add_key(empty_color, ' ', "nothing");
  chart.write(file);
}

struct CauseMark {
  glm::vec3 color;
  char sign;
};

// Okabe and Ito's colours, linear, with a letter each; order as in Cause.
constexpr std::array<CauseMark, cause_count> cause_marks = {{{{0.604F, 0.193F, 0.386F}, 'L'},
                                                             {{0.093F, 0.456F, 0.815F}, 'C'},
                                                             {{0.0F, 0.168F, 0.445F}, 'D'},
                                                             {{0.665F, 0.112F, 0.0F}, 'I'},
                                                             {{0.791F, 0.347F, 0.0F}, 'Y'},
                                                             {{0.0F, 0.342F, 0.171F}, 'K'},
                                                             {{0.871F, 0.776F, 0.054F}, 'T'},
                                                             {{0.02F, 0.02F, 0.02F}, '?'}}};

void write_causes(const View& view, const std::string& name, const Frame& frame,
                  const OrderingFailures& failures, const std::filesystem::path& file) {
  std::uint64_t all = 0;
  for (const std::uint64_t pixels : failures.pixels) all += pixels;
  Chart chart(view.width, view.height, name + ": wrong pixels by cause", [&](int i, int j) {
    const std::size_t pixel = pixel_of(view, i, j);
    const std::uint32_t pair = failures.pair_at[pixel];
    if (pair != background_id) return cause_marks[static_cast<std::size_t>(failures.pairs[pair].cause)].color;
    // The picture in pale grey, so that one sees where one is.
    const glm::vec4& color = frame.color[pixel];
    const float grey = 0.2126F * color.r + 0.7152F * color.g + 0.0722F * color.b;
    return glm::vec3(0.55F + 0.45F * (grey + (1.0F - color.a)));
  });
  chart.add_words(counted(all, "failing pixel"));
  for (std::size_t cause = 0; cause < cause_count; ++cause) {
    if (failures.pixels[cause] == 0) continue;
    chart.add_key(cause_marks[cause].color, cause_marks[cause].sign,
                  std::string(cause_names[cause]) + " " + grouped(failures.pixels[cause]));
  }
  chart.write(file);
}

/// How often each pixel was written while the algorithm ran once more.
Counts overdraw(const View& view, const AlgorithmSpec& spec, const RenderOptions& options) {
  Counts counts(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
  Frame frame(view.width, view.height);
  const auto count = [&](const Event& event) {
    const bool writes = event.kind == EventKind::painted || event.kind == EventKind::fragment_stored ||
                        event.kind == EventKind::nearest_replaced ||
                        (event.kind == EventKind::depth_tested && event.passed);
    if (writes && event.i >= 0) ++counts[pixel_of(view, event.i, event.j)];
  };
  spec.algorithm->prepare(*view.scene, spec.settings, options)->trace(view, options, count, frame);
  return counts;
}

}  // namespace

void write_scene_heatmaps(const View& view, const exact::ExactAnswer& exact, const exact::Nearest& nearest,
                          const RenderOptions& options, const std::filesystem::path& folder) {
  write_depths(view, nearest, folder / "depth.png");
  write_counts(view, list_lengths(view, exact, options.progress), "length of the exact depth lists",
               "triangles at a pixel", folder / "list-length.png");
}

void write_algorithm_heatmaps(const View& view, const AlgorithmSpec& spec, const Frame& frame,
                              const OrderingFailures& failures, const RenderOptions& options,
                              const std::filesystem::path& folder) {
  const std::string stem = file_stem(spec);
  write_causes(view, spec.text(), frame, failures, folder / (stem + "-errors.png"));
  write_counts(view, overdraw(view, spec, options), spec.text() + ": how often a pixel was written",
               "times written", folder / (stem + "-overdraw.png"));
}

}  // namespace hsr
