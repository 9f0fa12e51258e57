#include <algorithm>

#include "text_layout.h"
#include "window/panels/panels.h"

namespace hsr::window {
namespace {

/// Work is told of when it has taken this long; what is done sooner needs no word.
constexpr double patience_ms = 120.0;

bool draw_running(Ui& ui, Session& session) {
  bool any = false;
  for (const Workbench::Running& piece : session.bench.running()) {
    if (piece.milliseconds < patience_ms) continue;
    any = true;
    const std::string text = piece.what + (piece.stage.empty() ? "" : ": " + piece.stage);
    ImGui::ProgressBar(static_cast<float>(std::clamp(piece.done, 0.0, 1.0)), {14.0F * ui.em, 0.0F},
                       text.c_str());
    ImGui::SameLine();
  }
  if (any && ui.button("Stop", "Stop all work; the last picture stays (Esc)")) session.bench.cancel();
  return any;
}

std::string picture_line(Session& session) {
  const Workbench& bench = session.bench;
  const auto picture = bench.picture();
  if (!picture) return {};
  const Extent size = bench.picture_size();
  std::string line = bench.maker_name() + ", " + std::to_string(size.width) + " x " +
                     std::to_string(size.height) + ", " + milliseconds(picture->render_ms);
  if (const auto judgement = bench.judgement()) {
    const exact::Errors& errors = judgement->errors;
    line += ", " + grouped(errors.wrong) + " wrong, " + grouped(errors.holes) + " holes, " +
            grouped(errors.leaks) + " leaks";
  }
  const auto causes = bench.causes();
  const std::uint64_t blends = causes ? causes->of(Cause::transparency_unsorted) : 0;
  if (blends > 0) line += ", " + grouped(blends) + " wrong blends";
  return line;
}

}  // namespace

void draw_status(Ui& ui, Session& session, const Area& area) {
  ui.begin_panel("status", area.corner, area.size,
                 ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollbar);
  ImGui::SetCursorPosY(std::max(0.0F, (area.size.y - ImGui::GetFrameHeight()) / 2.0F));
  ImGui::AlignTextToFramePadding();
  if (draw_running(ui, session)) {
    // The bars say it all.
  } else if (const auto problems = session.bench.problems(); !problems.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.bad);
    ImGui::TextUnformatted(
        ("\xE2\x9C\x97 " + problems.front().substr(0, problems.front().find('\n'))).c_str());
    ImGui::PopStyleColor();
    ui.note("problem", problems.front());
  } else if (session.bench.cancelled()) {
    ImGui::TextUnformatted("stopped");
    ImGui::SameLine();
    if (ui.button("Go on", "Begin again what was stopped")) session.bench.retry();
  } else if (session.has_message()) {
    ImGui::TextUnformatted(session.message.c_str());
  } else {
    ImGui::TextUnformatted(picture_line(session).c_str());
  }
  ui.end_panel();
}

}  // namespace hsr::window
