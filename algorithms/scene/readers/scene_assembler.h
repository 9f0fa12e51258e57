#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/readers/messages.h"
#include "scene/scene.h"
#include "scene/triangulate.h"

namespace hsr {

/// Puts a scene together from what a reader finds, in file order: checks every number and index,
/// triangulates, counts faces, and warns of what it drops. What comes out satisfies scene.h.
class SceneAssembler {
 public:
  /// `first_index` is what the format counts vertices from, for messages.
  SceneAssembler(Warnings& warnings, std::int64_t first_index);

  /// Adds a vertex. One that is not finite is warned of, with `reason` if there is a better one than
  /// that, keeps its index, and spoils its faces.
  void add_position(const glm::vec3& position, const Place& place, std::string_view reason = {});

  /// Adds a polygon. `corners` count vertices from 0 and may refer to later ones; a face with an
  /// index below 0 or, at the end, without vertex, is dropped, as is one with fewer than 3 corners
  /// or a vertex that is not finite.
  void add_face(std::span<const std::int64_t> corners, std::uint32_t material, const Place& place);

  /// Counts and warns of a face that the reader itself cannot use because of a bad index.
  void drop_for_index(const std::string& reason, const Place& place);

  std::size_t vertices() const { return scene_.positions.size(); }
  bool has_triangles() const { return !scene_.triangles.empty(); }

  /// The scene, without name, materials and camera. Throws InputError if bad indices have left no
  /// face at all. Call once, at the end.
  Scene finish();

 private:
  /// A face with a corner whose vertex has not come yet.
  struct Postponed {
    std::size_t triangles_before;  // where its triangles belong
    std::size_t first_corner;      // in postponed_corners_
    std::size_t corners;
    std::uint32_t material;
    Place place;
  };

  void keep_face(std::span<const std::int64_t> corners, std::uint32_t material, const Place& place,
                 std::vector<Triangle>& triangles);
  bool is_usable(std::span<const std::int64_t> corners, const Place& place);
  void warn_of_repeats(std::span<const std::int64_t> corners, const Place& place);
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t material,
                    std::vector<Triangle>& triangles);
  void merge_postponed();
  void number_faces();
  void clear_positions_that_are_not_finite();

  Warnings& warnings_;
  std::int64_t first_index_;
  Scene scene_;
  std::vector<Postponed> postponed_;
  std::vector<std::int64_t> postponed_corners_;
  std::uint32_t faces_ = 0;
  std::uint64_t without_area_ = 0;
  std::uint64_t not_finite_ = 0;
  std::string first_bad_index_;       // the message about it, as an error
  std::vector<glm::vec3> outline_;    // scratch
  std::vector<CornerTriple> cut_;     // scratch
  std::vector<std::int64_t> sorted_;  // scratch
};

}  // namespace hsr
