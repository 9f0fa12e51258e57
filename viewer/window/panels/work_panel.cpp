#include <span>

#include "text_layout.h"
#include "window/panels/panels.h"

namespace hsr::window {
namespace {

void row(Ui& ui, const std::string& name, const std::string& value) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.faint_text);
  ImGui::TextUnformatted(name.c_str());
  ImGui::PopStyleColor();
  ImGui::TableNextColumn();
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(value.c_str()).x;
  if (room > 0.0F) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room);
  ImGui::TextUnformatted(value.c_str());
}

std::string bytes_text(std::uint64_t bytes) {
  constexpr double thousand = 1000.0;
  const auto size = static_cast<double>(bytes);
  if (size < thousand * thousand) return three_digits(size / thousand) + " kB";
  return three_digits(size / thousand / thousand) + " MB";
}

std::string words_of(std::string name) {
  for (char& letter : name) letter = letter == '_' ? ' ' : letter;
  return name;
}

void put_right(const std::string& text) {
  ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(text.c_str()).x);
  ImGui::TextUnformatted(text.c_str());
}

/// The time that the skip saves, below its count.
void draw_saved(Ui& ui, Session& session, const Skip& skip) {
  const auto times = session.bench.skip_times();
  if (!times) return;
  const auto found = times->saved.find(skip.name);
  if (found == times->saved.end()) return;
  const SkipTimes::Saved& saved = found->second;
  // What is less than this part of the picture's time is noise.
  constexpr double noise = 0.03;
  std::string text = "saves nothing that can be measured";
  if (saved.ms > noise * times->with_ms)
    text = (saved.at_least ? "saves more than " : "saves ") + milliseconds(saved.ms);
  if (saved.ms < -noise * times->with_ms) text = "costs " + milliseconds(-saved.ms);
  ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.faint_text);
  put_right(text);
  ImGui::PopStyleColor();
  ui.note(("saved by " + std::string(skip.name)).c_str(),
          "Measured: the same picture with and without the skip, in turns");
}

/// Where a picture takes so long that what skips save is only measured when somebody asks.
void draw_measure_button(Ui& ui, Session& session) {
  const auto times = session.bench.skip_times();
  if (!times || !times->too_long) return;
  if (session.bench.measures_skips()) return ui.faint_paragraph("measuring what each saves ...");
  ui.faint_paragraph("What each saves is measured on request, as a picture takes more than a second.");
  if (ui.button("Measure", "Makes the picture with and without each skip, in the background (Esc stops)"))
    session.bench.measure_skips_patiently();
}

}  // namespace

void draw_work_panel(Ui& ui, Session& session) {
  State& state = session.bench.state;
  const auto picture = session.bench.picture();
  session.bench.want_skip_times(true);
  const std::span<const Skip> skips =
      session.bench.shows_elsewhere() ? std::span<const Skip>() : state.algorithm.algorithm->skips;
  for (const Skip& skip : skips) {
    bool used = !state.skips_off.contains(skip.name);
    std::string label = "skip " + std::string(skip.name);
    if (ui.checkbox(label.c_str(), used, std::string(skip.meaning))) {
      if (used) {
        state.skips_off.erase(std::string(skip.name));
      } else {
        state.skips_off.insert(std::string(skip.name));
      }
    }
    if (!picture || !session.bench.picture_is_current()) continue;
    const auto count = picture->report.skipped.find(skip.name);
    if (count == picture->report.skipped.end()) continue;
    ImGui::SameLine();
    put_right(grouped(count->second));
    draw_saved(ui, session, skip);
  }
  draw_measure_button(ui, session);
  if (!picture || !ImGui::BeginTable("work", 2, ImGuiTableFlags_SizingStretchProp)) return;
  row(ui, "build (once for a scene)", milliseconds(picture->prepare_ms));
  row(ui, "render", milliseconds(picture->render_ms));
  row(ui, "memory", bytes_text(picture->report.bytes));
  for (const auto& [name, count] : picture->report.counters) row(ui, words_of(name), grouped(count));
  ImGui::EndTable();
}

}  // namespace hsr::window
