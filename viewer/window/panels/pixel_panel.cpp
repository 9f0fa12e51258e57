#include <SDL.h>

#include "failures/ordering_failures.h"
#include "text_layout.h"
#include "window/files.h"
#include "window/panels/cycle_graph.h"
#include "window/panels/depth_plot.h"
#include "window/panels/overlay_marks.h"
#include "window/panels/panels.h"

namespace hsr::window {
namespace {

void color_cell(Ui& ui, ImU32 color) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float side = ImGui::GetTextLineHeight();
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + side, at.y + side}, color);
  ImGui::GetWindowDrawList()->AddRect(at, {at.x + side, at.y + side}, ui.palette.line);
  ImGui::Dummy({side, side});
}

/// Which columns the list has room for: what is less often asked for goes first.
struct ListColumns {
  bool side = true;
  bool opacity = true;
  int count() const { return 4 + (side ? 1 : 0) + (opacity ? 1 : 0); }
};

ListColumns columns_for(float width, float em) {
  constexpr float all = 22.0F;  // heights of the letters
  constexpr float without_side = 18.0F;
  return {width >= all * em, width >= without_side * em};
}

void draw_row(Ui& ui, const Story& story, std::size_t k, const ListColumns& columns) {
  const exact::Fragment& fragment = story.pixel.list[k];
  const auto cell = [](const std::string& text) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text.c_str());
  };
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  color_cell(ui, screen_color(story.colors[k]));
  // An arrow says which one is shown, also to who does not see its colour.
  cell((fragment.id == story.pixel.id ? "\xE2\x86\x92 " : "") + std::to_string(fragment.id));
  cell((fragment.tied ? "= " : "") + significant(fragment.depth, 6));
  if (columns.opacity) cell(significant(story.colors[k].a, 2));
  if (columns.side) cell(story.fronts[k] ? "front" : "back");
  ImGui::TableNextColumn();
  color_cell(ui, screen_color(story.so_far[k]));
}

void draw_list(Ui& ui, const Story& story) {
  const std::size_t count = story.pixel.list.size();
  constexpr std::size_t most_rows = 8;
  const float height =
      (static_cast<float>(std::min(count, most_rows)) + 1.6F) * ImGui::GetTextLineHeightWithSpacing();
  constexpr ImGuiTableFlags flags =
      ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit;
  ui.pause_recording();
  const ListColumns columns = columns_for(ImGui::GetContentRegionAvail().x, ui.em);
  if (ImGui::BeginTable("list", columns.count(), flags, {0.0F, height})) {
    ui.resume_recording();
    ImGui::TableSetupScrollFreeze(0, 1);
    for (const char* title : {"", "triangle", "depth"}) ImGui::TableSetupColumn(title);
    if (columns.opacity) ImGui::TableSetupColumn("opacity");
    if (columns.side) ImGui::TableSetupColumn("side");
    ImGui::TableSetupColumn("so far");
    ImGui::TableHeadersRow();
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(count));
    while (clipper.Step()) {
      for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k)
        draw_row(ui, story, static_cast<std::size_t>(k), columns);
    }
    ImGui::EndTable();
  }
}

void draw_history(Ui& ui, const Story& story) {
  for (const HistoryLine& line : story.history) {
    const char* mark = !line.decided ? "\xE2\x80\xA2 " : line.passed ? "\xE2\x9C\x93 " : "\xE2\x9C\x97 ";
    ImU32 color = ui.palette.text;
    if (line.decided) color = line.passed ? ui.palette.good : ui.palette.faint_text;
    if (line.departure) color = ui.palette.bad;
    ui.colored_paragraph(color,
                         mark + line.sentence +
                             (line.departure ? "  \xE2\x86\x90 here it departs from the exact answer" : ""));
  }
  if (story.history_total > story.history.size()) {
    ui.faint_paragraph("and " + grouped(story.history_total - story.history.size()) + " more steps");
  }
}

void draw_copies(Ui& ui, Session& session, const Story& story) {
  if (ui.button("Copy", "All of this as text (also: hsr pixel)")) {
    SDL_SetClipboardText(story.text.c_str());
    session.tell("copied");
  }
  ImGui::SameLine();
  if (ui.button("CSV", "The list as a table in a file")) save_list(session, story);
  ImGui::SameLine();
  bool log_depth = session.bench.state.log_depth;
  if (ui.checkbox("log depth", log_depth, "Depths by their order of magnitude"))
    session.bench.state.log_depth = log_depth;
}

void draw_story(Ui& ui, Session& session, const Story& story) {
  ui.paragraph(story.explanation);
  if (const FailingPair* pair = failing_pair(session)) {
    ui.colored_paragraph(ui.palette.bad, "\xE2\x9C\x97 " + sentence(*pair));
    if (!pair->cycle.empty()) draw_cycle(ui, pair->cycle, *story.scene);
  }
  if (!story.pixel.list.empty() && ui.heading("Depth list")) {
    draw_depth_plot(ui, story, session.bench.state.log_depth, session.bench.state.theme);
    draw_list(ui, story);
  }
  draw_copies(ui, session, story);
  if (ui.heading("What the algorithm did here")) draw_history(ui, story);
}

}  // namespace

void draw_pixel_panel(Ui& ui, Session& session, const Area& area) {
  ui.begin_panel("pixel", area.corner, area.size);
  const auto pixel = session.pixel_in_question();
  session.bench.want_story(pixel);
  if (!pixel) {
    ui.faint_paragraph(
        "Point at a pixel to read what is there; click to keep it. N goes to the next wrong one.");
    ui.end_panel();
    return;
  }
  ui.colored_paragraph(ui.palette.accent,
                       "Pixel " + std::to_string(pixel->x) + ", " + std::to_string(pixel->y));
  if (const auto story = session.bench.story()) {
    draw_story(ui, session, *story);
  } else {
    ui.faint_paragraph(session.bench.busy() ? "looking ..." : "there is no picture to look into");
  }
  ui.end_panel();
}

}  // namespace hsr::window
