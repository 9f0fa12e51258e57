#include <algorithm>
#include <array>
#include <cmath>

#include "text_layout.h"
#include "window/files.h"
#include "window/panels/panels.h"
#include "window/playing.h"

namespace hsr::window {
namespace {

void draw_buttons(Ui& ui, Session& session) {
  if (ui.button("|\xE2\x97\x80", "To the beginning (Home)")) go_to_step(session, 0);
  ImGui::SameLine();
  if (ui.button("\xE2\x97\x80", "One step back (comma)")) step_by(session, -1);
  ImGui::SameLine();
  if (ui.toggle(session.playing ? "Pause" : "Play", session.playing, "Space")) toggle_playing(session);
  ImGui::SameLine();
  if (ui.button("\xE2\x96\xB6", "One step forward (period)")) step_by(session, 1);
  ImGui::SameLine();
  if (ui.button("\xE2\x96\xB6|", "To the end (End)")) {
    if (const auto trace = session.bench.trace()) go_to_step(session, trace->total);
  }
  struct Jump {
    const char* label;
    const char* tip;
    void (*go)(Session&);
  };
  static constexpr std::array jumps = {
      Jump{"\xE2\x86\x90 pixel", "The step before at the selected pixel ([)",
           [](Session& s) { go_to_mark(s, MarkKind::pixel, -1); }},
      Jump{"pixel \xE2\x86\x92", "The next step at the selected pixel (])",
           [](Session& s) { go_to_mark(s, MarkKind::pixel, 1); }},
      Jump{"face \xE2\x86\x92", "The next step of the face at the selected pixel (Shift ])",
           [](Session& s) { go_to_mark(s, MarkKind::face, 1); }},
      Jump{"turn \xE2\x86\x92", "The next exchange, cycle, crossing or split (X)",
           [](Session& s) { go_to_mark(s, MarkKind::turn, 1); }},
      Jump{"departure", "The first step after which a wrong triangle is seen for good (F)", go_to_departure}};
  for (const Jump& jump : jumps) {
    ui.beside(jump.label, &jump == jumps.data() ? 1.5F * ui.em : -1.0F);
    if (ui.button(jump.label, jump.tip)) jump.go(session);
  }
}

void draw_choices(Ui& ui, Session& session) {
  State& state = session.bench.state;
  ui.beside("GIF", 1.5F * ui.em);
  if (ui.button("GIF", "The steps as an animation in a file (Ctrl G)")) save_gif(session);
  ui.beside("steps of the pixel", 1.5F * ui.em);
  ImGui::SetNextItemWidth(5.5F * ui.em);
  auto of = static_cast<std::size_t>(state.steps_of);
  if (ui.combo("steps", of, steps_of_names(),
               "Of the whole picture, of the selected pixel, or of its face")) {
    state.steps_of = static_cast<StepsOf>(of);
    state.step = 0;
  }
  ui.beside("steps a second by a slider", 1.5F * ui.em);
  ImGui::SetNextItemWidth(8.0F * ui.em);
  (void)ui.slider("a second", state.speed, 1.0F, 1e6F, "%.0f", "Steps a second when playing",
                  ImGuiSliderFlags_Logarithmic);
}

/// Marks on a strip, a height and a colour for each kind.
void draw_marks(Ui& ui, const Marks& marks, std::uint64_t total, const ImVec2& at, float width,
                float height) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto x = [&](std::uint64_t step) {
    return at.x + width * static_cast<float>(static_cast<double>(step) /
                                             static_cast<double>(std::max<std::uint64_t>(total, 1)));
  };
  // No more than one mark for each pixel of the screen.
  const auto draw = [&](const std::vector<std::uint64_t>& steps, float from, float to, ImU32 color) {
    float last = -10.0F;
    for (const std::uint64_t step : steps) {
      const float here = std::floor(x(step));
      if (here <= last) continue;
      last = here;
      list.AddLine({here, at.y + from * height}, {here, at.y + to * height}, color,
                   std::max(1.0F, ui.stroke));
    }
  };
  draw(marks.turns, 0.0F, 0.33F, ui.palette.warn);
  draw(marks.face, 0.33F, 0.66F, ui.palette.second);
  draw(marks.pixel, 0.66F, 1.0F, ui.palette.text);
  if (!marks.departure) return;
  const float here = x(*marks.departure);
  const float size = 0.4F * ui.em;
  list.AddTriangleFilled({here, at.y + height}, {here - size, at.y}, {here + size, at.y}, ui.palette.bad);
}

void draw_time_line(Ui& ui, Session& session, std::uint64_t total) {
  State& state = session.bench.state;
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::SetNextItemWidth(width);
  const std::uint64_t least = 0;
  std::uint64_t step = state.step;
  const std::string format = "step " + grouped(step) + " of " + grouped(total);
  if (ImGui::SliderScalar("##time", ImGuiDataType_U64, &step, &least, &total, format.c_str(),
                          ImGuiSliderFlags_NoInput | ImGuiSliderFlags_AlwaysClamp)) {
    session.playing = false;
    state.step = std::min(step, total);
  }
  ui.note("time line");
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = 0.7F * ui.em;
  ImGui::Dummy({width, height});
  ui.note(
      "marks",
      "Above: exchanges, cycles, crossings, splits. Middle: the selected face. Below: the selected pixel. "
      "The wedge: the first departure from the exact answer.");
  if (const auto marks = session.bench.marks()) draw_marks(ui, *marks, total, at, width, height);
}

}  // namespace

void draw_steps_panel(Ui& ui, Session& session, const Area& area) {
  ui.begin_panel("steps", area.corner, area.size);
  const auto trace = session.bench.trace();
  if (!trace) {
    ui.faint_paragraph("counting the steps ...");
  } else {
    draw_time_line(ui, session, trace->total);
    const auto moment = session.bench.moment();
    ui.paragraph(moment && !moment->sentence.empty() ? moment->sentence : "nothing is drawn yet");
  }
  // Last, as in a narrow window they need several rows, and the sentence must be seen.
  draw_buttons(ui, session);
  draw_choices(ui, session);
  ui.end_panel();
}

}  // namespace hsr::window
