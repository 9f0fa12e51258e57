#include "window/panels/lesson_text.h"

#include <algorithm>
#include <span>
#include <vector>

#include "window/panels/text_flow.h"

namespace hsr::window {
namespace {

class Page {
 public:
  explicit Page(Ui& ui) : ui_(ui) {}

  void draw(std::span<const Block> blocks) {
    for (const Block& block : blocks) {
      ImGui::PushID(&block);
      draw(block);
      ImGui::PopID();
    }
  }

  void heading(const std::string& text) {
    Inline run;
    run.text = text;
    words({&run, 1}, ui_.fonts.heading);
  }

  const std::string& clicked() const { return clicked_; }

 private:
  void draw(const Block& block) {
    switch (block.kind) {
      case Block::Kind::heading:
        return words(block.words, block.level < 3 ? ui_.fonts.heading : ui_.fonts.strong);
      case Block::Kind::paragraph:
        if (!is_figure(block)) words(block.words, ui_.fonts.plain);  // the picture stands beside the text
        return;
      case Block::Kind::code:
        return code(block.text);
      case Block::Kind::script:
        return fold("what this step does", block, [&] { code(block.text); });
      case Block::Kind::list:
        return list(block);
      case Block::Kind::table:
        return table(block);
      case Block::Kind::details:
        return fold(block.text, block, [&] { draw(std::span(block.parts)); });
      default:
        return;
    }
  }

  static bool is_figure(const Block& block) {
    return block.words.size() == 1 && block.words[0].kind == Inline::Kind::image;
  }

  void words(std::span<const Inline> words, ImFont* font, float scale = 1.0F) {
    const std::string link = draw_text_flow(ui_, words, {font, ui_.palette.text, scale});
    if (!link.empty()) clicked_ = link;
  }

  void code(const std::string& text) {
    ImGui::PushFont(ui_.fonts.code);
    ImGui::PushStyleColor(ImGuiCol_Text, ui_.palette.faint_text);
    ImGui::Indent(0.6F * ui_.em);
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::Unindent(0.6F * ui_.em);
    ImGui::PopStyleColor();
    ImGui::PopFont();
  }

  template <class Draw>
  void fold(const std::string& label, const Block&, Draw draw_inside) {
    const bool open = ImGui::TreeNodeEx("##fold", ImGuiTreeNodeFlags_NoTreePushOnOpen, "%s", label.c_str());
    ui_.note(label.c_str());
    if (!open) return;
    ImGui::Indent(0.8F * ui_.em);
    draw_inside();
    ImGui::Unindent(0.8F * ui_.em);
    ImGui::Spacing();
  }

  void list(const Block& block) {
    int number = block.level;
    const float indent = (block.level > 0 ? 1.9F : 1.2F) * ui_.em;
    for (const Block& item : block.parts) {
      const ImVec2 place = ImGui::GetCursorScreenPos();
      const std::string mark = block.level > 0 ? std::to_string(number++) + "." : "\u2022";
      const float gap = 0.12F * ui_.em;  // above each line of text
      ui_.draw_text(*ImGui::GetWindowDrawList(), {place.x, place.y + gap}, ui_.palette.text, mark);
      ImGui::Indent(indent);
      ImGui::PushID(&item);
      draw(std::span(item.parts));
      ImGui::PopID();
      ImGui::Unindent(indent);
    }
  }

  void table(const Block& block) {
    if (block.parts.empty() || block.parts[0].parts.empty()) return;
    const int columns = static_cast<int>(block.parts[0].parts.size());
    constexpr ImGuiTableFlags flags =
        ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_BordersOuter | ImGuiTableFlags_SizingStretchProp;
    std::vector<float> weights;
    float all = 0.0F;
    for (std::size_t column = 0; column < block.parts[0].parts.size(); ++column) {
      weights.push_back(weight(block, column));
      all += weights.back() + 2.0F * ImGui::GetStyle().CellPadding.x;
    }
    constexpr float least_scale = 0.75F;
    const float scale = std::clamp(ImGui::GetContentRegionAvail().x / all, least_scale, 1.0F);
    if (!ImGui::BeginTable("##table", columns, flags)) return;
    for (const float column : weights)
      ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, column);
    for (const Block& row : block.parts) {
      ImGui::TableNextRow();
      for (const Block& cell : row.parts) {
        ImGui::TableNextColumn();
        words(cell.words, &row == &block.parts[0] ? ui_.fonts.strong : ui_.fonts.plain, scale);
      }
    }
    ImGui::EndTable();
  }

  /// How much of the width a column wants: long texts may be wrapped, so they do not count in full.
  float weight(const Block& block, std::size_t column) {
    float widest = ui_.em;
    for (const Block& row : block.parts) {
      if (column >= row.parts.size()) continue;
      widest = std::max(widest, text_flow_width(ui_, row.parts[column].words, {ui_.fonts.strong, 0}));
    }
    return std::min(widest + 0.4F * ui_.em, 14.0F * ui_.em);
  }

  Ui& ui_;
  std::string clicked_;
};

}  // namespace

std::string draw_lesson_step(Ui& ui, const OpenLesson& lesson, std::size_t step) {
  const LessonStep& shown = lesson.steps[step];
  Page page(ui);
  if (shown.continued) page.heading(shown.title + " (continued)");
  page.draw(std::span(lesson.document.blocks).subspan(shown.begin, shown.end - shown.begin));
  return page.clicked();
}

}  // namespace hsr::window
