#include "scene/readers/scene_assembler.h"

#include <algorithm>
#include <cmath>

#include "scene/errors.h"

namespace hsr {

namespace {

/// More vertices or triangles than this are refused: indices then fit 31 bits everywhere.
constexpr std::size_t greatest_count = 2147483647;

bool is_finite(const glm::vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

}  // namespace

SceneAssembler::SceneAssembler(Warnings& warnings, std::int64_t first_index)
    : warnings_(warnings), first_index_(first_index) {}

void SceneAssembler::add_position(const glm::vec3& position, const Place& place, std::string_view reason) {
  if (scene_.positions.size() == greatest_count) {
    throw InputError(place_message(warnings_.file(), place, "more than 2147483647 vertices"));
  }
  if (!is_finite(position)) {
    ++not_finite_;
    warnings_.add("vertices that are not finite", place, [&] {
      return "vertex " + std::to_string(static_cast<std::int64_t>(vertices()) + first_index_) +
             (reason.empty() ? " is not finite" : ": " + std::string(reason));
    });
  }
  scene_.positions.push_back(position);
}

void SceneAssembler::add_face(std::span<const std::int64_t> corners, std::uint32_t material,
                              const Place& place) {
  if (corners.size() < 3) {
    warnings_.add("faces with fewer than 3 corners", place,
                  [&] { return "face with " + counted(corners.size(), "corner", "corners") + " dropped"; });
    return;
  }
  const auto known = static_cast<std::int64_t>(vertices());
  if (std::any_of(corners.begin(), corners.end(), [&](std::int64_t corner) { return corner >= known; })) {
    postponed_.push_back(
        {scene_.triangles.size(), postponed_corners_.size(), corners.size(), material, place});
    postponed_corners_.insert(postponed_corners_.end(), corners.begin(), corners.end());
    return;
  }
  keep_face(corners, material, place, scene_.triangles);
}

void SceneAssembler::drop_for_index(const std::string& reason, const Place& place) {
  if (first_bad_index_.empty()) {
    first_bad_index_ = place_message(warnings_.file(), place, reason);
  }
  warnings_.add("faces with a bad vertex index", place, [&] { return reason + ": face dropped"; });
}

bool SceneAssembler::is_usable(std::span<const std::int64_t> corners, const Place& place) {
  const auto known = static_cast<std::int64_t>(vertices());
  for (const std::int64_t corner : corners) {
    if (corner < 0 || corner >= known) {
      drop_for_index("vertex index " + std::to_string(corner + first_index_) + " out of range (" +
                         counted(vertices(), "vertex", "vertices") + ")",
                     place);
      return false;
    }
    if (not_finite_ > 0 && !is_finite(scene_.positions[static_cast<std::size_t>(corner)])) {
      warnings_.add("faces with a vertex that is not finite", place, [&] {
        return "face dropped: its vertex " + std::to_string(corner + first_index_) + " is not finite";
      });
      return false;
    }
  }
  return true;
}

void SceneAssembler::keep_face(std::span<const std::int64_t> corners, std::uint32_t material,
                               const Place& place, std::vector<Triangle>& triangles) {
  if (!is_usable(corners, place)) {
    return;
  }
  warn_of_repeats(corners, place);
  const auto index = [&](std::size_t k) { return static_cast<std::uint32_t>(corners[k]); };
  if (corners.size() == 3) {
    add_triangle(index(0), index(1), index(2), material, triangles);
  } else {
    outline_.clear();
    for (const std::int64_t corner : corners) {
      outline_.push_back(scene_.positions[static_cast<std::size_t>(corner)]);
    }
    if (!triangulate(outline_, cut_)) {
      warnings_.add("faces whose outline crosses itself", place,
                    [] { return std::string("face's outline crosses itself"); });
    }
    for (const CornerTriple& triple : cut_) {
      add_triangle(index(triple[0]), index(triple[1]), index(triple[2]), material, triangles);
    }
  }
  ++faces_;
}

/// Warns of a vertex that follows itself or comes three times. Twice is how a bridge to a hole looks.
void SceneAssembler::warn_of_repeats(std::span<const std::int64_t> corners, const Place& place) {
  bool repeats = corners.front() == corners.back();
  for (std::size_t k = 1; k < corners.size(); ++k) {
    repeats = repeats || corners[k] == corners[k - 1];
  }
  if (!repeats && corners.size() >= 6) {  // in fewer, three equal corners include neighbours
    sorted_.assign(corners.begin(), corners.end());
    std::sort(sorted_.begin(), sorted_.end());
    for (std::size_t k = 2; k < sorted_.size(); ++k) {
      repeats = repeats || sorted_[k] == sorted_[k - 2];
    }
  }
  if (repeats) {
    warnings_.add("faces that repeat a corner", place, [] { return std::string("face repeats a corner"); });
  }
}

void SceneAssembler::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t material,
                                  std::vector<Triangle>& triangles) {
  if (triangles.size() == greatest_count) {
    throw InputError(place_message(warnings_.file(), {}, "more than 2147483647 triangles"));
  }
  const std::vector<glm::vec3>& positions = scene_.positions;
  without_area_ += has_no_area(positions[a], positions[b], positions[c]) ? 1 : 0;
  triangles.push_back({{a, b, c}, faces_, material});
}

/// Puts the faces that had to wait for their vertices where they belong.
void SceneAssembler::merge_postponed() {
  if (postponed_.empty()) {
    return;
  }
  std::vector<Triangle> merged;
  merged.reserve(scene_.triangles.size() + postponed_.size());
  std::size_t done = 0;
  const auto copy_until = [&](std::size_t end) {
    for (; done < end; ++done) {
      merged.push_back(scene_.triangles[done]);
    }
  };
  for (const Postponed& face : postponed_) {
    copy_until(face.triangles_before);
    keep_face(std::span(postponed_corners_).subspan(face.first_corner, face.corners), face.material,
              face.place, merged);
  }
  copy_until(scene_.triangles.size());
  scene_.triangles = std::move(merged);
  number_faces();
}

/// Counts faces anew: so far each run of triangles has a number of its own, but not in order.
void SceneAssembler::number_faces() {
  std::uint32_t face = 0;
  std::uint32_t last = 0;
  for (std::size_t i = 0; i < scene_.triangles.size(); ++i) {
    const std::uint32_t old = scene_.triangles[i].face;
    face += i > 0 && old != last ? 1 : 0;
    last = old;
    scene_.triangles[i].face = face;
  }
}

/// No face uses them any more; they stay so that indices are those of the file.
void SceneAssembler::clear_positions_that_are_not_finite() {
  if (not_finite_ == 0) {
    return;
  }
  for (glm::vec3& position : scene_.positions) {
    if (!is_finite(position)) {
      position = glm::vec3(0.0F);
    }
  }
}

Scene SceneAssembler::finish() {
  merge_postponed();
  clear_positions_that_are_not_finite();
  if (scene_.triangles.empty()) {
    if (!first_bad_index_.empty()) {
      throw InputError(first_bad_index_);
    }
    warnings_.add("", {}, [&] {
      return "no faces" + (vertices() > 0 ? ", only " + counted(vertices(), "vertex", "vertices") : "");
    });
  }
  if (without_area_ > 0) {
    warnings_.add("", {}, [&] {
      return counted(without_area_, "triangle has", "triangles have") + " no area and will cover nothing";
    });
  }
  return std::move(scene_);
}

}  // namespace hsr
