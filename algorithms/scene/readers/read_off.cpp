#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "scene/readers/readers.h"
#include "scene/readers/scene_assembler.h"
#include "scene/readers/text_lines.h"

namespace hsr {

namespace {

class OffReader {
 public:
  explicit OffReader(const Input& input)
      : input_(input), lines_(input.bytes), assembler_(input.warnings, 0), progress_(input) {}

  Scene read() {
    if (!lines_.next_line()) {
      input_.fail({}, "no OFF header");
    }
    read_header();
    read_counts();
    for (std::int64_t i = 0; i < vertices_; ++i) {
      next_row(i, vertices_, "vertices");
      read_vertex();
    }
    for (std::int64_t i = 0; i < faces_; ++i) {
      next_row(i, faces_, "faces");
      read_face();
    }
    if (lines_.next_line()) {
      input_.warnings.add("", place(), [] { return std::string("what follows the last face is ignored"); });
    }
    return assembler_.finish();
  }

 private:
  Place place() const { return Place::line(lines_.line()); }

  /// The word before the counts: letters for what each vertex row holds beside its position, which
  /// comes first in all of them. The header may be missing.
  void read_header() {
    std::int64_t number = 0;
    TextLines first = lines_;
    if (first.whole(number)) {
      return;
    }
    const std::string_view header = lines_.word();
    std::string_view letters = header;
    for (const std::string_view prefix : {"ST", "C", "N"}) {
      letters.remove_prefix(letters.starts_with(prefix) ? prefix.size() : 0);
    }
    plain_ = header == "OFF";
    if (letters == "4OFF" || letters == "nOFF" || letters == "4nOFF") {
      input_.fail(place(),
                  "OFF with other than three dimensions (" + in_quotes(header) + ") is not supported");
    }
    if (letters != "OFF") {
      input_.fail(place(), "not an OFF file: it begins with " + in_quotes(header));
    }
  }

  void read_counts() {
    if (!lines_.find_word() && !lines_.next_line()) {
      input_.fail(place(), "the file ends before its counts");
    }
    std::int64_t edges = 0;
    const bool complete = lines_.whole(vertices_) && lines_.whole(faces_);
    const bool has_edges = complete && lines_.whole(edges);
    if (!complete || (!has_edges && lines_.find_word())) {
      const std::string_view word = lines_.word();
      if (word == "BINARY") {
        input_.fail(place(), "binary OFF is not supported");
      }
      input_.fail(place(), "numbers of vertices and faces expected" +
                               (word.empty() ? std::string() : ", not " + in_quotes(word)));
    }
    check_count(vertices_, 6, "vertices");  // "0 0 0\n"
    check_count(faces_, 2, "faces");        // "0\n"
  }

  void check_count(std::int64_t count, std::size_t least_bytes, std::string_view what) const {
    if (count < 0) {
      input_.fail(place(), "negative number of " + std::string(what));
    }
    if (static_cast<std::uint64_t>(count) > (lines_.bytes_left() + 1) / least_bytes) {
      input_.fail(place(), "truncated: " + std::to_string(count) + " " + std::string(what) +
                               " promised, but only " + counted(lines_.bytes_left(), "byte", "bytes") +
                               " left");
    }
  }

  void next_row(std::int64_t row, std::int64_t all, std::string_view what) {
    row_ = row;
    progress_.at(lines_.offset());
    if (!lines_.next_line()) {
      fail_truncated(all, what);
    }
  }

  [[noreturn]] void fail_truncated(std::int64_t all, std::string_view what) const {
    input_.fail(place(), "truncated: the file ends after " + std::to_string(row_) + " of " +
                             std::to_string(all) + " " + std::string(what));
  }

  void read_vertex() {
    glm::vec3 position(0.0F);
    for (int k = 0; k < 3; ++k) {
      if (!lines_.decimal(position[k])) {
        const std::string_view word = lines_.word();
        if (word.empty()) {
          input_.fail(place(), "vertex has " + counted(k, "number", "numbers") + " of 3");
        }
        position[k] = std::numeric_limits<float>::quiet_NaN();
      }
    }
    if (plain_ && lines_.find_word()) {
      input_.warnings.add("vertices with more than 3 numbers", place(),
                          [] { return std::string("numbers after the position are ignored"); });
    }
    assembler_.add_position(position, place());
  }

  /// A row is a count, that many indices, and perhaps a colour. Long rows may go on in the next line
  /// if that then ends with them: anything else would mistake the next face for corners.
  void read_face() {
    const Place start = place();
    std::int64_t count = 0;
    if (!lines_.whole(count) || count < 0) {
      input_.fail(start, "number of corners expected, not " + in_quotes(lines_.word()));
    }
    if (static_cast<std::uint64_t>(count) > lines_.bytes_left()) {
      fail_truncated(faces_, "faces");
    }
    corners_.clear();
    bool wrapped = false;
    while (std::cmp_less(corners_.size(), count)) {
      std::int64_t corner = 0;
      if (lines_.whole(corner)) {
        corners_.push_back(corner);
      } else if (lines_.find_word()) {
        input_.fail(place(), in_quotes(lines_.word()) + " is not a vertex index");
      } else if (!lines_.next_line()) {
        fail_truncated(faces_, "faces");
      } else {
        wrapped = true;
      }
    }
    if (wrapped && lines_.find_word()) {
      input_.fail(start, "face has fewer than its " + std::to_string(count) + " corners");
    }
    assembler_.add_face(corners_, no_material, start);
  }

  const Input& input_;
  TextLines lines_;
  SceneAssembler assembler_;
  ReadProgress progress_;
  std::int64_t row_ = 0;  // of the vertices or faces
  std::int64_t vertices_ = 0;
  std::int64_t faces_ = 0;
  bool plain_ = false;
  std::vector<std::int64_t> corners_;  // scratch
};

}  // namespace

Scene read_off(const Input& input) { return OffReader(input).read(); }

}  // namespace hsr
