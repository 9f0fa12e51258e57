#include <SDL.h>

#include <algorithm>

#include "window/lesson.h"
#include "window/panels/lesson_text.h"
#include "window/panels/panels.h"

namespace hsr::window {
namespace {

void draw_way(Ui& ui, Session& session, const OpenLesson& lesson) {
  State& state = session.bench.state;
  const int steps = static_cast<int>(lesson.steps.size());
  ImGui::PushFont(ui.fonts.strong);
  ui.paragraph(std::to_string(lesson.number) + ". " + std::string(lesson.lesson->title));
  ImGui::PopFont();
  const int before = state.lesson_step;
  if (ui.button("Back##lesson", "The step before (Page up)") && before > 1) go_on(session, -1);
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted((std::to_string(before) + " of " + std::to_string(steps)).c_str());
  ImGui::SameLine();
  if (ui.button("Next##lesson", "The next step (Page down)")) go_on(session, 1);
  ui.beside("Lessons ...");
  if (ui.button("Lessons ...##lesson", "The list of lessons (H)")) session.lesson_list = true;
  ui.beside("Settings");
  if (ui.button("Settings##lesson", "Scene, algorithm, work in place of the text")) state.lesson_aside = true;
  ui.beside("Close");
  if (ui.button("Close##lesson", "Leave the lesson; the picture stays")) close_lesson(session);
}

/// Where one has wandered off, the way back.
void draw_return(Ui& ui, Session& session) {
  if (shows_lesson_step(session)) return ui.faint_paragraph("The picture shows what this step speaks of.");
  if (ui.button("Back to the step",
                "Scene, camera, algorithm, settings, pixel and overlay as the step sets them (B)"))
    show_lesson_step(session);
}

/// The text begins at its top wherever one was in the step before.
void scroll_to_top_of(Session& session) {
  const std::pair<int, int> place = {session.bench.state.lesson, session.bench.state.lesson_step};
  if (session.lesson_scrolled == place) return;
  session.lesson_scrolled = place;
  ImGui::SetScrollY(0.0F);
}

}  // namespace

void draw_lesson_panel(Ui& ui, Session& session, const Area& area) {
  const OpenLesson* lesson = lesson_of(session);
  if (lesson == nullptr) return;
  const float top = std::min(area.size.y / 3.0F, 6.3F * ui.em);
  ui.begin_panel("lesson's way", area.corner, {area.size.x, top});
  draw_way(ui, session, *lesson);
  draw_return(ui, session);
  ui.end_panel();
  lesson = lesson_of(session);  // a button may have opened another one
  if (lesson == nullptr) return;
  ui.begin_panel("lesson", {area.corner.x, area.corner.y + top}, {area.size.x, area.size.y - top});
  scroll_to_top_of(session);
  const std::string link =
      draw_lesson_step(ui, *lesson, static_cast<std::size_t>(session.bench.state.lesson_step - 1));
  if (!link.empty()) {
    SDL_SetClipboardText(link.c_str());
    session.tell("in the clipboard: " + link);
  }
  ui.end_panel();
}

void draw_lesson_list(Ui& ui, Session& session) {
  if (!session.lesson_list) return;
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const ImVec2 size = {std::min(36.0F * ui.em, window.x - 2.0F * ui.em),
                       std::min(27.0F * ui.em, window.y - 2.0F * ui.em)};
  ImGui::SetNextWindowFocus();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 2.0F * ui.stroke);
  ui.begin_panel("lessons", {(window.x - size.x) / 2.0F, (window.y - size.y) / 2.0F}, size,
                 ImGuiWindowFlags_None);
  ImGui::PopStyleVar();
  ui.colored_paragraph(ui.palette.accent, "Lessons");
  for (const Lesson& lesson : lesson_catalog()) {
    const int number = lesson_number(lesson);
    const std::string label = std::to_string(number) + ". " + std::string(lesson.title);
    if (ImGui::Selectable(label.c_str(), session.bench.state.lesson == number)) {
      open_lesson(session, number, 1);
      session.lesson_list = false;
    }
    ui.note(label.c_str());
  }
  ImGui::Spacing();
  if (ui.button("Close##lessons", "H or Esc")) session.lesson_list = false;
  ImGui::SameLine();
  ui.faint_paragraph(
      "Page down is the next step, Page up the one before, B shows again what the step shows.");
  ui.end_panel();
}

}  // namespace hsr::window
