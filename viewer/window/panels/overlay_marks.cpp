#include "window/panels/overlay_marks.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "window/causes.h"
#include "window/outline.h"

namespace hsr::window {
namespace {

/// What stands for the failures in a square of the screen.
struct Crowd {
  glm::vec2 sum{0.0F};
  float count = 0.0F;
};

}  // namespace

void draw_failures(Ui& ui, Session& session, const PicturePlace& place, ImDrawList& list) {
  const auto judgement = session.bench.judgement();
  const auto causes = session.bench.causes();
  if (!judgement || !causes) return;
  // Squares of the screen in which there is one mark of a cause at most, so that there are never too many.
  const float square = std::max(1.6F * ui.em, place.zoom);
  const auto columns = static_cast<std::size_t>(place.area.size.x / square) + 2;
  const auto rows = static_cast<std::size_t>(place.area.size.y / square) + 2;
  std::vector<Crowd> crowds(columns * rows * cause_count);
  const auto width = static_cast<std::uint32_t>(place.size.width);
  for (std::size_t pixel = 0; pixel < causes->pair_at.size(); ++pixel) {
    const std::uint32_t pair = causes->pair_at[pixel];
    if (pair == background_id) continue;
    const ImVec2 at =
        place.screen({static_cast<double>(pixel % width) + 0.5, static_cast<double>(pixel / width) + 0.5});
    if (!place.contains(at)) continue;
    const auto column = static_cast<std::size_t>((at.x - place.area.corner.x) / square);
    const auto row = static_cast<std::size_t>((at.y - place.area.corner.y) / square);
    const auto cause = static_cast<std::size_t>(causes->pairs[pair].cause);
    Crowd& crowd = crowds[(row * columns + column) * cause_count + cause];
    crowd.sum += glm::vec2(at.x, at.y);
    crowd.count += 1.0F;
  }
  const float radius = std::min(0.32F * ui.em, 0.4F * square);
  for (std::size_t k = 0; k < crowds.size(); ++k) {
    if (crowds[k].count == 0.0F) continue;
    const glm::vec2 middle = crowds[k].sum / crowds[k].count;
    draw_cause(list, {middle.x, middle.y}, radius, ui.stroke, static_cast<Cause>(k % cause_count),
               session.bench.state.theme);
  }
}

void draw_grid(Ui& ui, const PicturePlace& place, ImDrawList& list) {
  if (place.zoom < 8.0F) return;
  const ImVec2 least = place.area.corner;
  const ImVec2 greatest = {least.x + place.area.size.x, least.y + place.area.size.y};
  const glm::vec2 first = place.raster(least);
  const glm::vec2 last = place.raster(greatest);
  const float right = std::min(place.screen({place.size.width, 0}).x, greatest.x);
  const float bottom = std::min(place.screen({0, place.size.height}).y, greatest.y);
  const ImU32 color = IM_COL32(128, 128, 128, 90);
  for (int i = std::max(0, static_cast<int>(first.x));
       i <= std::min(place.size.width, static_cast<int>(last.x) + 1); ++i) {
    const float x = place.screen({i, 0}).x;
    list.AddLine({x, std::max(place.origin.y, least.y)}, {x, bottom}, color, ui.stroke);
  }
  for (int j = std::max(0, static_cast<int>(first.y));
       j <= std::min(place.size.height, static_cast<int>(last.y) + 1); ++j) {
    const float y = place.screen({0, j}).y;
    list.AddLine({std::max(place.origin.x, least.x), y}, {right, y}, color, ui.stroke);
  }
}

void draw_selection(Ui& ui, Session& session, const PicturePlace& place, ImDrawList& list) {
  if (!session.bench.state.pixel) return;
  const glm::ivec2 pixel = *session.bench.state.pixel;
  ImVec2 least = place.screen({pixel.x, pixel.y});
  ImVec2 greatest = place.screen({pixel.x + 1, pixel.y + 1});
  const float gap = std::max(0.0F, (0.7F * ui.em - (greatest.x - least.x)) / 2.0F);
  least = {least.x - gap, least.y - gap};
  greatest = {greatest.x + gap, greatest.y + gap};
  list.AddRect(least, greatest, IM_COL32(0, 0, 0, 255), 0.0F, 0, 5.0F * ui.stroke);
  list.AddRect(least, greatest, IM_COL32(255, 255, 255, 255), 0.0F, 0, 2.0F * ui.stroke);
}

namespace {

/// What is drawn round lines so that they are seen on any picture: the opposite of the letters' brightness.
ImU32 halo(const Palette& palette) {
  const bool dark_letters = (palette.text & 0xFFU) < 128U;
  return dark_letters ? IM_COL32(255, 255, 255, 230) : IM_COL32(0, 0, 0, 210);
}

void draw_polygon(ImDrawList& list, const PicturePlace& place, const std::vector<glm::dvec2>& polygon,
                  ImU32 ink, float width) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    list.AddLine(place.screen(polygon[k]), place.screen(polygon[(k + 1) % polygon.size()]), ink, width);
  }
}

}  // namespace

void draw_outline(Ui& ui, const View& view, std::uint32_t id, const PicturePlace& place, ImDrawList& list,
                  ImU32 ink) {
  const std::vector<glm::dvec2> polygon = outline(view, id);
  draw_polygon(list, place, polygon, halo(ui.palette), 5.0F * ui.stroke);
  draw_polygon(list, place, polygon, ink, 2.0F * ui.stroke);
}

const FailingPair* failing_pair(const Session& session) {
  const auto causes = session.bench.causes();
  const auto pixel = session.pixel_in_question();
  const auto picture = session.bench.picture();
  if (!causes || !pixel || !picture || pixel->x >= picture->frame.width ||
      pixel->y >= picture->frame.height) {
    return nullptr;
  }
  const std::uint32_t pair = causes->pair_at[picture->frame.index(pixel->x, pixel->y)];
  return pair == background_id ? nullptr : &causes->pairs[pair];
}

void draw_failing_pair(Ui& ui, Session& session, const PicturePlace& place, ImDrawList& list) {
  const FailingPair* pair = failing_pair(session);
  const auto truth = session.bench.truth();
  if (pair == nullptr || !truth) return;
  for (const std::uint32_t id : pair->cycle)
    draw_outline(ui, truth->view, id, place, list, ui.palette.faint_text);
  draw_outline(ui, truth->view, pair->shown, place, list, ui.palette.first);
  draw_outline(ui, truth->view, pair->nearest, place, list, ui.palette.second);
  if (pair->cause != Cause::interpenetration) return;
  const ImVec2 from = place.screen(pair->crossing[0]);
  const ImVec2 to = place.screen(pair->crossing[1]);
  list.AddLine(from, to, IM_COL32(0, 0, 0, 255), 6.0F * ui.stroke);
  list.AddLine(from, to, IM_COL32(255, 255, 255, 255), 3.0F * ui.stroke);
}

}  // namespace hsr::window
