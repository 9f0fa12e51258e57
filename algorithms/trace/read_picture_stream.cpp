#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <istream>
#include <limits>
#include <set>
#include <string_view>

#include "scene/errors.h"
#include "trace/event_json.h"
#include "trace/picture_stream.h"

namespace hsr {

namespace {

/// Bytes that one step may have, for the bound of its section.
constexpr std::size_t most_step_bytes = 400;
constexpr std::size_t most_camera_bytes = 1000;

/// Reads a number and nothing else.
template <class Number>
bool read_number(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  while (!line.empty()) {
    const std::size_t begin = line.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) break;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(" \t\r\n"), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return words;
}

/// Whether a step of this kind is about a triangle.
bool has_triangle(EventKind kind) {
  return kind != EventKind::ray_started && kind != EventKind::node_entered &&
         kind != EventKind::node_passed_by && kind != EventKind::cell_entered &&
         kind != EventKind::list_sorted;
}

/// Whether it is about a pixel.
bool has_pixel(EventKind kind) { return kind >= EventKind::painted; }

class PictureReader {
 public:
  PictureReader(std::istream& stream, const std::string& name, const PictureLimits& limits)
      : stream_(stream), name_(name), limits_(limits) {}

  ToldPicture read() {
    read_heading();
    std::set<std::string, std::less<>> seen;
    while (true) {
      const std::string line = read_line();
      const std::vector<std::string_view> words = words_of(line);
      std::size_t bytes = 0;
      if (words.size() != 2 || !read_number(words[1], bytes))
        fail("a line \"NAME BYTES\" is expected where it has \"" + shown(line) + "\"");
      const std::string section(words[0]);
      if (section == "end") break;
      if (!seen.insert(section).second) fail("the section " + section + " is there twice");
      read_section(section, bytes);
    }
    for (const std::string_view wanted : {"id", "depth"}) {
      if (!seen.contains(wanted)) fail("the section " + std::string(wanted) + " is missing");
    }
    check_frame();
    return std::move(picture_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(name_ + ": " + what); }

  /// What was read of a line, so that it can be told: no control characters, not too long.
  static std::string shown(const std::string& line) {
    constexpr std::size_t most = 40;
    std::string text = line.substr(0, most);
    for (char& letter : text) {
      if (letter < ' ' || letter > '~') letter = '?';
    }
    return text;
  }

  std::string read_line() {
    constexpr std::size_t most = 200;
    std::string line;
    for (int letter = stream_.get(); letter != '\n'; letter = stream_.get()) {
      if (letter == std::istream::traits_type::eof()) fail("it ends before \"end 0\"");
      line += static_cast<char>(letter);
      if (line.size() == most) fail("a line \"NAME BYTES\" is expected where it has \"" + shown(line) + "\"");
    }
    return line;
  }

  void read_heading() {
    if (stream_.peek() == std::istream::traits_type::eof()) fail("it is empty");
    const std::string line = read_line();
    const std::vector<std::string_view> words = words_of(line);
    if (words.size() != 4 || words[0] != "hsr-picture")
      fail("this is no picture, which begins with \"hsr-picture 1 WIDTH HEIGHT\"; it begins with \"" +
           shown(line) + "\"");
    if (words[1] != "1")
      fail("a picture of version " + shown(std::string(words[1])) + "; this reads version 1");
    Frame& frame = picture_.frame;
    const bool numbers = read_number(words[2], frame.width) && read_number(words[3], frame.height);
    if (!numbers || std::min(frame.width, frame.height) < 1 ||
        std::max(frame.width, frame.height) > limits_.size)
      fail("width and height are not whole numbers from 1 to " + std::to_string(limits_.size));
  }

  void read_section(const std::string& section, std::size_t bytes) {
    Frame& frame = picture_.frame;
    if (section == "id") return read_pixels(section, bytes, frame.id);
    if (section == "depth") return read_pixels(section, bytes, frame.depth);
    if (section == "color") return read_pixels(section, bytes, frame.color);
    if (section == "lists") return read_lists(bytes);
    if (section == "camera") return read_camera(bytes);
    if (section == "steps") return read_steps(bytes);
    fail("there is no section \"" + shown(section) +
         "\"; those there are: camera, id, depth, color, lists, "
         "steps, end");
  }

  /// Reads so many numbers; no more memory is taken than there are bytes.
  template <class Number>
  void read_numbers(std::size_t count, std::vector<Number>& numbers) {
    constexpr std::size_t block = 1U << 20U;
    while (numbers.size() < count) {
      const std::size_t first = numbers.size();
      numbers.resize(std::min(count, first + block));
      const auto bytes = static_cast<std::streamsize>((numbers.size() - first) * sizeof(Number));
      stream_.read(reinterpret_cast<char*>(numbers.data() + first), bytes);
      if (stream_.gcount() != bytes) fail("it is cut off");
    }
  }

  template <class Number>
  void read_pixels(const std::string& section, std::size_t bytes, std::vector<Number>& numbers) {
    const std::size_t count = picture_.frame.pixel_count();
    if (bytes != count * sizeof(Number)) {
      fail("the section " + section + " has " + std::to_string(bytes) + " bytes in place of " +
           std::to_string(count * sizeof(Number)));
    }
    read_numbers(count, numbers);
  }

  std::string read_text(std::size_t bytes, std::size_t most, const std::string& section) {
    if (bytes > most) fail("the section " + section + " is too long");
    std::vector<char> letters;
    read_numbers(bytes, letters);
    return {letters.begin(), letters.end()};
  }

  void read_lists(std::size_t bytes) {
    const std::size_t pixels = picture_.frame.pixel_count();
    std::vector<std::uint32_t> counts;
    if (bytes < 4 * pixels) fail("the section lists is too short");
    read_numbers(pixels, counts);
    FragmentLists lists;
    lists.begin.reserve(pixels + 1);
    lists.begin.push_back(0);
    std::size_t sum = 0;
    for (const std::uint32_t count : counts) {
      sum += count;
      lists.begin.push_back(sum);
    }
    if (sum > limits_.fragments) fail("it has " + std::to_string(sum) + " fragments, which is too many");
    if (bytes != 4 * pixels + 12 * sum) fail("the section lists does not have 12 bytes for each fragment");
    std::vector<std::uint32_t> numbers;
    read_numbers(3 * sum, numbers);
    lists.fragments.reserve(sum);
    for (std::size_t k = 0; k < sum; ++k) {
      const ListFragment fragment = {numbers[3 * k], std::bit_cast<float>(numbers[3 * k + 1]),
                                     numbers[3 * k + 2] != 0};
      if (fragment.id >= limits_.triangles)
        fail("a list has triangle " + std::to_string(fragment.id) + ", which the scene does not have");
      if (std::isnan(fragment.depth)) fail("a list has a depth that is no number");
      lists.fragments.push_back(fragment);
    }
    picture_.frame.lists = std::move(lists);
  }

  void read_camera(std::size_t bytes) {
    const std::string text = read_text(bytes, most_camera_bytes, "camera");
    const std::vector<std::string_view> words = words_of(text);
    std::array<double, 12> n{};
    bool good = words.size() == n.size();
    for (std::size_t k = 0; good && k < n.size(); ++k)
      good = read_number(words[k], n[k]) && std::isfinite(n[k]);
    if (!good) fail("the section camera is not twelve numbers");
    picture_.view =
        ToldView{{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}, n[9]}, n[10], n[11]};
  }

  void read_steps(std::size_t bytes) {
    const std::string text = read_text(bytes, limits_.steps * most_step_bytes, "steps");
    picture_.tells_steps = true;
    std::string_view rest = text;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      const std::string_view line = rest.substr(0, end);
      rest.remove_prefix(std::min(end + 1, rest.size()));
      if (words_of(line).empty()) continue;
      const std::size_t number = picture_.steps.size() + 1;
      if (number > limits_.steps) fail("it has more than " + std::to_string(limits_.steps) + " steps");
      try {
        picture_.steps.push_back(event_from_json_line(line).event);
      } catch (const InputError& error) {
        fail("step " + std::to_string(number) + ": " + error.what());
      }
      check_step(picture_.steps.back(), number);
    }
  }

  void check_step(const Event& event, std::size_t number) const {
    const std::string step = "step " + std::to_string(number) + ": ";
    const Frame& frame = picture_.frame;
    const bool no_pixel = event.i == -1 && event.j == -1;
    const bool in_picture = 0 <= event.i && event.i < frame.width && 0 <= event.j && event.j < frame.height;
    if (!in_picture && (!no_pixel || has_pixel(event.kind))) fail(step + "it is at no pixel of the picture");
    const auto known = [&](std::uint32_t id) { return id == background_id || id < limits_.triangles; };
    if (!known(event.p) || !known(event.q) || (has_triangle(event.kind) && event.p == background_id))
      fail(step + "it names a triangle that the scene does not have");
  }

  void check_frame() {
    Frame& frame = picture_.frame;
    for (std::size_t pixel = 0; pixel < frame.pixel_count(); ++pixel) {
      const auto where = [&] {
        const auto width = static_cast<std::size_t>(frame.width);
        return "pixel " + std::to_string(pixel % width) + ", " + std::to_string(pixel / width) + ": ";
      };
      if (frame.id[pixel] == background_id) {
        frame.depth[pixel] = std::numeric_limits<float>::infinity();
      } else if (frame.id[pixel] >= limits_.triangles) {
        fail(where() + "there is no triangle " + std::to_string(frame.id[pixel]) + "; the scene has " +
             std::to_string(limits_.triangles));
      }
      if (std::isnan(frame.depth[pixel])) fail(where() + "the depth is no number");
    }
    for (std::size_t pixel = 0; pixel < frame.color.size(); ++pixel) {
      const glm::vec4& color = frame.color[pixel];
      if (!std::isfinite(color.r + color.g + color.b + color.a))
        fail("the colour of a pixel is no number: " + std::to_string(pixel));
    }
  }

  std::istream& stream_;
  const std::string& name_;
  PictureLimits limits_;
  ToldPicture picture_;
};

}  // namespace

ToldPicture read_picture_stream(std::istream& stream, const std::string& name, const PictureLimits& limits) {
  return PictureReader(stream, name, limits).read();
}

}  // namespace hsr
