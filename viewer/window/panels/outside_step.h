#pragma once

#include <vector>

#include "window/outline.h"
#include "window/results/steps.h"
#include "window/results/structure.h"
#include "window/session.h"
#include "window/ui.h"

namespace hsr::window {

/// Draws points and lines of the world as the camera of the outside view sees them.
class OutsideDrawing {
 public:
  OutsideDrawing(ImDrawList& list, const View& view, const ImVec2& corner)
      : list_(list), view_(view), corner_(corner) {}

  void line(const glm::dvec3& from, const glm::dvec3& to, ImU32 color, float width) const;
  void dot(const glm::dvec3& at, float radius, ImU32 color, ImU32 rim) const;
  void ring(const glm::dvec3& at, float radius, ImU32 color, float width) const;
  void box(const Box& box, ImU32 color, float width) const;
  void word(Ui& ui, const glm::dvec3& at, ImU32 color, const char* text) const;

 private:
  ImVec2 screen(const glm::dvec2& raster) const {
    return {corner_.x + static_cast<float>(raster.x), corner_.y + static_cast<float>(raster.y)};
  }
  ImDrawList& list_;
  const View& view_;
  ImVec2 corner_;
};

/// The boxes of a hierarchy at a level (and leaves above it), or the cells of a grid that hold triangles.
void draw_structure(Ui& ui, const OutsideDrawing& drawing, const Structure& structure, int level);

/// The nodes and cells that a ray came to: thick those that it entered, the last one thickest, thin those
/// that it passed by.
void draw_visited(Ui& ui, const OutsideDrawing& drawing, const Structure& structure,
                  const std::vector<Event>& events);

/// The failing pair at the pixel in question: what is shown, what ought to be, the cycle, and where they
/// cross.
void draw_pair_outside(Ui& ui, Session& session, const OutsideDrawing& drawing);

/// What the present step speaks of: P and Q, the plane that a test asks about or a cut is made by, a
/// fragment against the stored one, a list, a ray's boxes. `structure` may be null.
void draw_step_outside(Ui& ui, Session& session, const OutsideDrawing& drawing, const Moment& moment,
                       const Structure* structure);

}  // namespace hsr::window
