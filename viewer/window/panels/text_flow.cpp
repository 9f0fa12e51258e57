#include "window/panels/text_flow.h"

#include <algorithm>
#include <cfloat>
#include <utility>
#include <vector>

#include "window/panels/formula_box.h"

namespace hsr::window {
namespace {

/// What is not divided: a word, or a formula.
struct Atom {
  const Inline* run = nullptr;
  std::string_view letters;
  Pen pen;
  Reach reach;
  bool blank_before = false;  ///< and so a line may end before it
  bool may_break = false;     ///< the same without a blank, in a word that is too long for a line
  bool alone = false;         ///< in a line of its own
};

class Flow {
 public:
  Flow(Ui& ui, const TextStyle& style, float width) : ui_(ui), style_(style), width_(width) {}

  void add(const Inline& run) {
    const Pen pen = pen_of(run);
    if (run.kind == Inline::Kind::formula) {
      add_formula(run, pen);
    } else if (run.kind == Inline::Kind::line_break) {
      break_ = true;
    } else if (run.kind != Inline::Kind::image) {
      add_words(run, pen);
    }
  }

  /// How wide all of it is in one line.
  float natural_width() const {
    float width = 0.0F;
    for (const Atom& atom : atoms_) width += atom.reach.width + (atom.blank_before ? blank() : 0.0F);
    return width;
  }

  std::string draw() {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImVec2 place = ImGui::GetCursorScreenPos();
    const ImVec2 start = place;
    for (std::size_t begin = 0; begin < atoms_.size();) {
      const std::size_t end = end_of_line(begin);
      draw_line(list, begin, end, place);
      begin = end;
    }
    ImGui::Dummy({width_, std::max(place.y - start.y, 1.0F)});
    return clicked_;
  }

 private:
  float blank() const { return 0.3F * style_.scale * ui_.em; }

  Pen pen_of(const Inline& run) const {
    Pen pen;
    pen.font = run.kind == Inline::Kind::code ? ui_.fonts.code : run.strong ? ui_.fonts.strong : style_.font;
    pen.size =
        style_.scale * (run.kind == Inline::Kind::formula ? style_.font->FontSize : pen.font->FontSize);
    pen.color = run.address.empty() ? style_.color : ui_.palette.accent;
    pen.slanted = run.emphasis;
    return pen;
  }

  /// Smaller if no line has room for it.
  void add_formula(const Inline& run, Pen pen) {
    constexpr float least = 0.6F;
    Reach reach = put_formula(pen, *run.formula, run.display);
    if (reach.width > width_) {
      pen.size *= std::max(least, width_ / reach.width);
      reach = put_formula(pen, *run.formula, run.display);
    }
    atoms_.push_back({&run, {}, pen, reach, blank_, false, run.display});
    blank_ = false;
  }

  void add_words(const Inline& run, const Pen& pen) {
    std::string_view rest = run.text;
    while (!rest.empty()) {
      if (rest[0] == ' ') {
        blank_ = true;
        rest.remove_prefix(1);
        continue;
      }
      const std::string_view word = rest.substr(0, rest.find(' '));
      add_word(run, pen, word);
      rest.remove_prefix(word.size());
    }
  }

  /// In pieces if no line has room for it.
  void add_word(const Inline& run, const Pen& pen, std::string_view word) {
    bool first = true;
    while (!word.empty()) {
      std::string_view piece = word;
      Reach reach = put_letters(pen, piece);
      while (reach.width > width_ && piece.size() > 1) {
        std::size_t shorter = piece.size() - 1;
        while (shorter > 1 && (static_cast<unsigned char>(piece[shorter]) & 0xC0U) == 0x80U) --shorter;
        piece = piece.substr(0, shorter);
        reach = put_letters(pen, piece);
      }
      atoms_.push_back(
          {&run, piece, pen, reach, first && blank_, !first || std::exchange(break_, false), false});
      word.remove_prefix(piece.size());
      first = false;
    }
    blank_ = false;
  }

  /// The atoms up to the next place where a line may end.
  std::size_t end_of_group(std::size_t begin) const {
    std::size_t end = begin + 1;
    while (end < atoms_.size() && !atoms_[end].blank_before && !atoms_[end].may_break && !atoms_[end].alone &&
           !atoms_[end - 1].alone)
      ++end;
    return end;
  }

  std::size_t end_of_line(std::size_t begin) const {
    if (atoms_[begin].alone) return begin + 1;
    float x = 0.0F;
    std::size_t end = begin;
    while (end < atoms_.size() && !atoms_[end].alone) {
      const std::size_t next = end_of_group(end);
      float group = 0.0F;
      for (std::size_t k = end; k < next; ++k)
        group += atoms_[k].reach.width + (k > begin && atoms_[k].blank_before ? blank() : 0.0F);
      if (end > begin && x + group > width_) break;
      x += group;
      end = next;
    }
    return end;
  }

  void draw_line(ImDrawList& list, std::size_t begin, std::size_t end, ImVec2& place) {
    const float size = style_.scale * style_.font->FontSize;
    Reach line = {0.0F, 0.8F * size, 0.25F * size};
    for (std::size_t k = begin; k < end; ++k) {
      line.above = std::max(line.above, atoms_[k].reach.above);
      line.below = std::max(line.below, atoms_[k].reach.below);
    }
    const bool alone = atoms_[begin].alone;
    const float gap = (alone ? 0.5F : 0.12F) * size;
    const float base = place.y + gap + line.above;
    const float bottom = base + line.below + gap;
    float x = place.x;
    if (alone) x += std::max(0.0F, std::min(1.5F * size, width_ - atoms_[begin].reach.width));
    const bool seen = ImGui::IsRectVisible({place.x, place.y}, {place.x + width_, bottom});
    for (std::size_t k = begin; k < end; ++k) {
      const Atom& atom = atoms_[k];
      const float before = k > begin && atom.blank_before ? blank() : 0.0F;
      if (seen)
        draw_atom(list, atom, {x + before, base}, k > begin && atoms_[k - 1].run == atom.run ? before : 0.0F);
      x += before + atom.reach.width;
    }
    place.y = bottom;
  }

  /// `joined`: how far to the left the same run goes on.
  void draw_atom(ImDrawList& list, const Atom& atom, const ImVec2& start, float joined) {
    const ImVec2 least = {start.x - joined, start.y - atom.reach.above - 0.08F * ui_.em};
    const ImVec2 greatest = {start.x + atom.reach.width, start.y + atom.reach.below + 0.08F * ui_.em};
    if (atom.run->kind == Inline::Kind::code) {
      list.AddRectFilled({least.x - 2.0F, least.y}, {greatest.x + 2.0F, greatest.y},
                         ImGui::GetColorU32(ImGuiCol_FrameBg), 3.0F);
    }
    if (!atom.run->address.empty()) {
      const float y = start.y + 0.15F * ui_.em;
      list.AddLine({least.x, y}, {greatest.x, y}, ui_.palette.accent, ui_.stroke);
      if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(least, greatest)) {
        hovered_link(atom.run->address);
      }
    }
    if (atom.run->formula) {
      (void)put_formula(atom.pen, *atom.run->formula, atom.run->display, &list, start);
    } else {
      (void)put_letters(atom.pen, atom.letters, &list, start);
    }
  }

  void hovered_link(const std::string& address) {
    ui_.tip(address + "\nA click copies it.");
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) clicked_ = address;
  }

  Ui& ui_;
  TextStyle style_;
  float width_;
  std::vector<Atom> atoms_;
  bool blank_ = false;
  bool break_ = false;
  std::string clicked_;
};

}  // namespace

std::string draw_text_flow(Ui& ui, std::span<const Inline> words, const TextStyle& style) {
  Flow flow(ui, style, std::max(ImGui::GetContentRegionAvail().x, ui.em));
  for (const Inline& run : words) flow.add(run);
  ui.record(plain_text({words.begin(), words.end()}));
  return flow.draw();
}

float text_flow_width(Ui& ui, std::span<const Inline> words, const TextStyle& style) {
  Flow flow(ui, style, FLT_MAX);
  for (const Inline& run : words) flow.add(run);
  return flow.natural_width();
}

}  // namespace hsr::window
