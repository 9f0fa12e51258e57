#pragma once

#include <imgui.h>

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "window/theme.h"

namespace hsr::window {

class Workbench;

/// What is on the screen, for scripts: the words, and where each button stands.
struct Recorder {
  bool on = false;
  std::string words;
  std::map<std::string, ImVec4, std::less<>> places;  ///< left, top, right, bottom, by label
};

/// What a panel draws with: ImGui, and round it what all panels need.
///
/// Labels may end in "##word", which ImGui takes as part of the name and does not show.
class Ui {
 public:
  Ui(Workbench& the_bench, Recorder& recorder) : bench(the_bench), recorder_(recorder) {}

  Workbench& bench;
  Palette palette{};
  Fonts fonts;
  float em = 16.0F;     ///< height of the letters in pixels
  float stroke = 1.0F;  ///< width of a thin line in pixels

  /// A panel that fills the rectangle; must be ended.
  void begin_panel(const char* name, const ImVec2& corner, const ImVec2& size,
                   ImGuiWindowFlags flags = ImGuiWindowFlags_NoBringToFrontOnFocus);
  void end_panel();

  /// Puts the next button beside the last one if there is room for it, else below.
  void beside(const char* next_label, float gap = -1.0F);
  bool button(const char* label, const std::string& tip = {});
  /// A button that stays pressed while `on`.
  bool toggle(const char* label, bool on, const std::string& tip = {});
  bool checkbox(const char* label, bool& value, const std::string& tip = {});
  /// One of several names. Returns whether another was chosen.
  bool combo(const char* label, std::size_t& chosen, std::span<const std::string_view> names,
             const std::string& tip = {});
  bool slider(const char* label, float& value, float least, float greatest, const char* format,
              const std::string& tip = {}, ImGuiSliderFlags flags = 0);
  bool slider(const char* label, int& value, int least, int greatest, const std::string& tip = {});
  /// A heading that opens and closes what stands below it.
  bool heading(const char* label, bool open_at_first = true);
  /// A paragraph, wrapped at the panel's edge.
  void paragraph(const std::string& text);
  void faint_paragraph(const std::string& text);
  void colored_paragraph(ImU32 color, const std::string& text);
  /// A word in a drawing.
  void draw_text(ImDrawList& list, const ImVec2& place, ImU32 color, const std::string& text);

  /// Words that are drawn by other means, for scripts.
  void record(const std::string& text);

  /// Notes the last item for scripts and shows the tip while the mouse rests on it.
  void note(const char* label, const std::string& tip = {});
  /// Shows a tip at the mouse.
  void tip(const std::string& text);

  /// Round popups and tips, whose end would otherwise end the recording of the panel they belong to.
  void pause_recording();
  void resume_recording();

 private:
  Recorder& recorder_;
};

}  // namespace hsr::window
