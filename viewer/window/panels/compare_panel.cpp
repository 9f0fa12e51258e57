#include "text_layout.h"
#include "window/actions.h"
#include "window/causes.h"
#include "window/panels/algorithm_settings.h"
#include "window/panels/panels.h"

namespace hsr::window {
namespace {

/// What the picture is compared with: the exact answer, or one of the algorithms.
void draw_other(Ui& ui, State& state) {
  std::vector<std::string_view> names = {"exact answer"};
  std::size_t chosen = 0;
  for (const Algorithm* algorithm : algorithm_catalog()) {
    if (state.other && state.other->algorithm == algorithm) chosen = names.size();
    names.push_back(algorithm->name);
  }
  ImGui::SetNextItemWidth(-0.4F * ImGui::GetContentRegionAvail().x);
  if (ui.combo("with", chosen, names, "What the picture is compared with")) {
    state.other.reset();
    if (chosen > 0) state.other = parse_algorithm_spec(names[chosen]);
  }
  if (!state.other) return;
  ImGui::PushID("other");
  draw_settings(ui, *state.other);
  ImGui::PopID();
}

/// The causes with their marks and counts.
void draw_causes(Ui& ui, Session& session) {
  const auto causes = session.bench.causes();
  if (!causes) return;
  for (std::size_t k = 0; k < cause_count; ++k) {
    const auto cause = static_cast<Cause>(k);
    if (causes->of(cause) == 0) continue;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float middle = ImGui::GetTextLineHeight() / 2.0F;
    draw_cause(*ImGui::GetWindowDrawList(), {at.x + 0.6F * ui.em, at.y + middle}, 0.32F * ui.em, ui.stroke,
               cause, session.bench.state.theme);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 1.5F * ui.em);
    ui.paragraph(grouped(causes->of(cause)) + " " + std::string(name_of(cause)));
  }
}

void draw_failure_buttons(Ui& ui, Session& session) {
  if (ui.button("\xE2\x86\x90 previous", "The wrong pixel before (Shift N)")) go_to_failure(session, -1);
  ImGui::SameLine();
  if (ui.button("next \xE2\x86\x92", "The next wrong pixel (N)")) go_to_failure(session, 1);
}

/// What is to be said where every pixel shows the right triangle: a blend may be wrong all the same.
void draw_blends(Ui& ui, Session& session, const Judgement& judgement) {
  const AlgorithmSpec& spec =
      session.bench.shows_elsewhere() ? program_spec() : session.bench.state.algorithm;
  if (!judgement.colors_differ() || spec.algorithm->traits.antialiased) {
    ui.colored_paragraph(ui.palette.good, "\xE2\x9C\x93 every pixel is right");
    return;
  }
  const auto causes = session.bench.causes();
  const std::uint64_t blends = causes ? causes->of(Cause::transparency_unsorted) : 0;
  if (blends > 0) {
    ui.colored_paragraph(ui.palette.bad, "\xE2\x9C\x97 " + grouped(blends) + " wrong blends");
    draw_causes(ui, session);
    draw_failure_buttons(ui, session);
    return;
  }
  ui.colored_paragraph(ui.palette.good, "\xE2\x9C\x93 every pixel shows the right triangle");
  ui.faint_paragraph(causes ? "Colours differ where something shines through (transparency: " +
                                  std::string(spec.algorithm->traits.transparency) + ")."
                            : "the blends are being checked");
}

void draw_counts(Ui& ui, Session& session) {
  const auto judgement = session.bench.judgement();
  if (!judgement) {
    if (session.bench.state.check && session.bench.picture_is_current())
      ui.faint_paragraph("the exact answer is on its way");
    return;
  }
  const exact::Errors& errors = judgement->errors;
  if (errors.wrong + errors.holes + errors.leaks == 0) {
    draw_blends(ui, session, *judgement);
  } else {
    // The shapes are those of the marks in the picture.
    ui.colored_paragraph(ui.palette.bad, "\xE2\x9C\x97 " + grouped(errors.wrong) + " wrong");
    if (errors.holes > 0)
      ui.colored_paragraph(ui.palette.warn, "\xE2\x97\x8B " + grouped(errors.holes) + " holes");
    if (errors.leaks > 0)
      ui.colored_paragraph(ui.palette.accent, "\xE2\x96\xA1 " + grouped(errors.leaks) + " leaks");
    draw_causes(ui, session);
    draw_failure_buttons(ui, session);
  }
  if (errors.other_of_tie > 0) {
    ui.faint_paragraph(counted(errors.other_of_tie, "pixel") + " of the other of two equally near: no error");
  }
}

}  // namespace

void draw_compare_panel(Ui& ui, Session& session) {
  State& state = session.bench.state;
  auto comparing = static_cast<std::size_t>(state.comparing);
  ImGui::SetNextItemWidth(-0.4F * ImGui::GetContentRegionAvail().x);
  if (ui.combo("compare", comparing, comparing_names(), "Show another picture of the same view too (C)")) {
    state.comparing = static_cast<Comparing>(comparing);
  }
  if (state.comparing != Comparing::off) draw_other(ui, state);
  auto overlay = static_cast<std::size_t>(state.overlay);
  ImGui::SetNextItemWidth(-0.4F * ImGui::GetContentRegionAvail().x);
  if (ui.combo("overlay", overlay, overlay_names(), "What is drawn over the picture (O)")) {
    state.overlay = static_cast<Overlay>(overlay);
  }
  (void)ui.checkbox("check every picture", state.check, "Hold every picture against the exact answer");
  draw_counts(ui, session);
}

}  // namespace hsr::window
