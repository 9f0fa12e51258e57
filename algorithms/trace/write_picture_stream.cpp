#include <array>
#include <bit>
#include <charconv>
#include <ostream>
#include <span>

#include "trace/event_json.h"
#include "trace/picture_stream.h"

namespace hsr {

namespace {

// Numbers are written as they lie in memory.
static_assert(std::endian::native == std::endian::little);

template <class Number>
void write_section(std::ostream& stream, std::string_view name, std::span<const Number> numbers) {
  stream << name << " " << numbers.size_bytes() << "\n";
  stream.write(reinterpret_cast<const char*>(numbers.data()),
               static_cast<std::streamsize>(numbers.size_bytes()));
}

void write_text(std::ostream& stream, std::string_view name, const std::string& text) {
  stream << name << " " << text.size() << "\n" << text;
}

void write_lists(std::ostream& stream, const FragmentLists& lists) {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(lists.begin.size() + 3 * lists.fragments.size());
  for (std::size_t pixel = 0; pixel + 1 < lists.begin.size(); ++pixel) {
    numbers.push_back(static_cast<std::uint32_t>(lists.begin[pixel + 1] - lists.begin[pixel]));
  }
  for (const ListFragment& fragment : lists.fragments) {
    numbers.push_back(fragment.id);
    numbers.push_back(std::bit_cast<std::uint32_t>(fragment.depth));
    numbers.push_back(fragment.tied ? 1U : 0U);
  }
  write_section<std::uint32_t>(stream, "lists", numbers);
}

std::string text_of(const ToldView& view) {
  std::string text;
  const auto append = [&text](double number) {
    std::array<char, 40> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    if (!text.empty()) text += ' ';
    text.append(digits.data(), end);
  };
  for (const glm::dvec3& point : {view.camera.eye, view.camera.target, view.camera.up}) {
    for (const double part : {point.x, point.y, point.z}) append(part);
  }
  for (const double number : {view.camera.vertical_fov_degrees, view.near_depth, view.far_depth})
    append(number);
  return text + "\n";
}

}  // namespace

void write_picture_stream(const ToldPicture& picture, std::ostream& stream) {
  const Frame& frame = picture.frame;
  stream << "hsr-picture 1 " << frame.width << " " << frame.height << "\n";
  if (picture.view) write_text(stream, "camera", text_of(*picture.view));
  write_section<std::uint32_t>(stream, "id", frame.id);
  write_section<float>(stream, "depth", frame.depth);
  if (!frame.color.empty()) write_section<glm::vec4>(stream, "color", frame.color);
  if (frame.lists) write_lists(stream, *frame.lists);
  if (picture.tells_steps) {
    std::string lines;
    std::uint64_t step = 0;
    for (const Event& event : picture.steps) lines += to_json_line({++step, event}) + "\n";
    write_text(stream, "steps", lines);
  }
  stream << "end 0\n";
}

}  // namespace hsr
