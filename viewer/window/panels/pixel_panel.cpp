#include "text_layout.h"
#include "window/panels/panels.h"

namespace hsr::window {

void draw_pixel_panel(Ui& ui, Session& session, const Area& area) {
  ui.begin_panel("pixel", area.corner, area.size);
  const auto pixel = session.pixel_in_question();
  if (!pixel) {
    ui.faint_paragraph(
        "Point at a pixel to read what is there; click to keep it. N goes to the next wrong one.");
    ui.end_panel();
    return;
  }
  ui.paragraph("pixel " + std::to_string(pixel->x) + ", " + std::to_string(pixel->y));
  const auto picture = session.bench.picture();
  if (picture && session.bench.picture_is_current() && pixel->x < picture->frame.width &&
      pixel->y < picture->frame.height) {
    const std::size_t index = picture->frame.index(pixel->x, pixel->y);
    const std::uint32_t id = picture->frame.id[index];
    ui.paragraph(id == background_id ? "background"
                                     : "triangle " + std::to_string(id) + " at depth " +
                                           significant(picture->frame.depth[index], 6));
  }
  ui.end_panel();
}

}  // namespace hsr::window
