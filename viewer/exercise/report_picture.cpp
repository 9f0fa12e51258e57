#include <algorithm>
#include <array>
#include <cmath>

#include "exercise/report.h"
#include "frame/frame.h"
#include "frame/write_image.h"
#include "scene/atomic_file.h"

namespace hsr {
namespace {

char letter_of(double number) {
  constexpr std::string_view letters = "0123456789abcdefghijklmnopqrstuvwxyz";
  if (std::isnan(number)) return '?';
  if (number < 0.0) return '.';
  return letters[static_cast<std::size_t>(std::fmod(number, static_cast<double>(letters.size())))];
}

struct Part {
  int first_i = 0;
  int first_j = 0;
  int width = 0;
  int height = 0;
};

int height_of(const CaseAnswer& answer) {
  return answer.width == 0 ? 0 : static_cast<int>(answer.numbers.size()) / answer.width;
}

double at(const CaseAnswer& answer, int i, int j) {
  return answer.numbers[static_cast<std::size_t>(j) * static_cast<std::size_t>(answer.width) +
                        static_cast<std::size_t>(i)];
}

bool differs(const CaseAnswer& got, const CaseAnswer& want, int i, int j) {
  const double a = at(got, i, j);
  const double b = at(want, i, j);
  return a != b && !(std::isnan(a) && std::isnan(b));
}

/// The whole if it is small, else as much of it as fits round the first difference.
Part shown_part(const CaseAnswer& got, const CaseAnswer& want) {
  constexpr int most_width = 30;
  constexpr int most_height = 24;
  const int height = height_of(want);
  Part part = {0, 0, std::min(want.width, most_width), std::min(height, most_height)};
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < want.width; ++i) {
      if (!differs(got, want, i, j)) continue;
      part.first_i = std::clamp(i - most_width / 2, 0, want.width - part.width);
      part.first_j = std::clamp(j - most_height / 2, 0, height - part.height);
      return part;
    }
  }
  return part;
}

/// Colours that stay apart for the colour-blind (Okabe and Ito 2008), as linear RGB.
glm::vec4 color_of(double number) {
  static constexpr std::array<std::array<float, 3>, 7> palette = {{{0.79F, 0.35F, 0.0F},
                                                                   {0.09F, 0.45F, 0.81F},
                                                                   {0.0F, 0.34F, 0.17F},
                                                                   {0.87F, 0.77F, 0.05F},
                                                                   {0.0F, 0.17F, 0.45F},
                                                                   {0.67F, 0.11F, 0.0F},
                                                                   {0.6F, 0.19F, 0.39F}}};
  if (!(number >= 0.0)) return {0.8F, 0.8F, 0.8F, 1.0F};
  const auto& rgb = palette[static_cast<std::size_t>(std::fmod(number, 7.0))];
  return {rgb[0], rgb[1], rgb[2], 1.0F};
}

}  // namespace

std::string picture_text(const CaseAnswer& got, const CaseAnswer& want) {
  if (got.width != want.width || got.numbers.size() != want.numbers.size())
    return "    the picture has another size than it ought to have\n";
  const Part part = shown_part(got, want);
  const std::string gap(3, ' ');
  const auto heading = [&](std::string word) {
    word.resize(static_cast<std::size_t>(std::max(part.width, 7)), ' ');
    return word + gap;
  };
  std::string text = "    " + heading("got") + heading("want") + "differs\n";
  const std::string fill(static_cast<std::size_t>(std::max(0, 7 - part.width)), ' ');
  for (int j = part.first_j; j < part.first_j + part.height; ++j) {
    std::string left;
    std::string middle;
    std::string right;
    for (int i = part.first_i; i < part.first_i + part.width; ++i) {
      left += letter_of(at(got, i, j));
      middle += letter_of(at(want, i, j));
      right += differs(got, want, i, j) ? 'x' : '.';
    }
    text.append("    ").append(left).append(fill).append(gap).append(middle).append(fill).append(gap);
    text.append(right).append("\n");
  }
  std::size_t count = 0;
  std::string first;
  for (int j = 0; j < height_of(want); ++j) {
    for (int i = 0; i < want.width; ++i) {
      if (!differs(got, want, i, j)) continue;
      if (count++ == 0) {
        first = "pixel (" + std::to_string(i) + ", " + std::to_string(j) + "): got " +
                letter_of(at(got, i, j)) + ", want " + letter_of(at(want, i, j));
      }
    }
  }
  text += "    " + std::to_string(count) + (count == 1 ? " pixel differs" : " pixels differ");
  if (count > 0) text += "; the first is " + first;
  if (part.first_i > 0 || part.first_j > 0) {
    text += "\n    (the part from column " + std::to_string(part.first_i) + " and row " +
            std::to_string(part.first_j) + " on is shown)";
  }
  return text + "\n    . background, 0-9 a-z numbers, x differs\n";
}

void write_picture_difference(const CaseAnswer& got, const CaseAnswer& want,
                              const std::filesystem::path& file) {
  if (got.width != want.width || got.numbers.size() != want.numbers.size()) return;
  constexpr int scale = 8;
  constexpr int gap = 2;
  const int height = height_of(want);
  Frame frame(scale * (3 * want.width + 2 * gap), scale * height);
  for (int j = 0; j < frame.height; ++j) {
    for (int i = 0; i < frame.width; ++i) {
      const int column = i / scale;
      const int place = column / (want.width + gap);
      const int x = column % (want.width + gap);
      const int y = j / scale;
      if (x >= want.width) continue;
      glm::vec4 color = place == 0 ? color_of(at(got, x, y)) : color_of(at(want, x, y));
      if (place == 2) {
        color =
            differs(got, want, x, y) ? glm::vec4(0.8F, 0.0F, 0.0F, 1.0F) : glm::vec4(0.9F, 0.9F, 0.9F, 1.0F);
      }
      frame.color[frame.index(i, j)] = color;
    }
  }
  write_png(frame, glm::vec3(1.0F), file);
}

std::vector<std::string> files_to_look_at(const ExerciseCheck& check, const std::filesystem::path& folder) {
  std::vector<std::string> lines;
  std::string view = check.accident.view;
  const auto failed = std::ranges::find(check.cases, false, &CaseResult::passed);
  if (failed != check.cases.end()) {
    view = failed->view;
    if (failed->want.width > 0) {
      write_picture_difference(failed->got, failed->want, folder / "difference.png");
      lines.push_back("As pictures:  " + (folder / "difference.png").string());
    }
  }
  if (view.empty()) return lines;
  const std::filesystem::path state = folder / "failure.hsr";
  write_file_atomically(state, [&](const std::filesystem::path& temporary) {
    write_bytes(temporary, "hsr-state 1\n" + view + "\n");
  });
  lines.push_back("The viewer:   hsr view " + plain_shell_word(state.string()));
  return lines;
}

}  // namespace hsr
