#include "window/panels/formula_box.h"

#include <algorithm>
#include <cfloat>
#include <vector>

namespace hsr::window {
namespace {

using Kind = Formula::Kind;

// All in heights of the letters.
constexpr float letters_above = 0.78F;
constexpr float letters_below = 0.22F;
constexpr float axis = 0.3F;  ///< where fractions are divided
constexpr float script_size = 0.74F;
constexpr float slant = 0.2F;
constexpr float lean = 0.1F;  ///< how far slanted letters lean over what comes next

/// A formula's parts are placed in two passes by the same functions: how far they reach, and on the list.
struct Placer {
  ImDrawList* list = nullptr;

  Reach put(const Pen& pen, const Formula& formula, bool display, const ImVec2& start) const;
  Reach row(const Pen& pen, const Formula& formula, bool display, const ImVec2& start) const;
  Reach fraction(const Pen& pen, const Formula& formula, bool display, const ImVec2& start) const;
  Reach root(const Pen& pen, const Formula& formula, bool display, const ImVec2& start) const;
  Reach script(const Pen& pen, const Formula& formula, bool display, const ImVec2& start) const;
  Reach limits(const Pen& pen, const Formula& formula, const ImVec2& start) const;
  Reach matrix(const Pen& pen, const Formula& formula, const ImVec2& start) const;
  Reach tall_sign(const Pen& pen, const std::string& text, const Reach& beside, const ImVec2& start) const;
  Reach reach_of(const Pen& pen, const Formula& formula, bool display) const {
    return Placer{nullptr}.put(pen, formula, display, {});
  }
};

void join(Reach& whole, const Reach& part) {
  whole.width += part.width;
  whole.above = std::max(whole.above, part.above);
  whole.below = std::max(whole.below, part.below);
}

Pen smaller(Pen pen) {
  pen.size *= script_size;
  return pen;
}

float room_of(const Formula& sign, bool after_value) {
  switch (sign.room) {
    case Formula::Room::relation:
      return 0.28F;
    case Formula::Room::binary:
      return after_value ? 0.22F : 0.0F;
    default:
      return 0.0F;
  }
}

/// Before and after the name of a function, such as log, that stands behind a value.
float name_room(const Formula& part, bool after_value) {
  const Formula& bearer = part.kind == Kind::script ? part.parts[0] : part;
  const bool name = bearer.kind == Kind::identifier && bearer.upright && bearer.text.size() > 1;
  return name && after_value ? 0.15F : 0.0F;
}

/// Bracket, bar or anything else, stretched to what stands beside it.
Reach Placer::tall_sign(const Pen& pen, const std::string& text, const Reach& beside,
                        const ImVec2& start) const {
  Pen tall = pen;
  tall.size = std::max(pen.size, beside.above + beside.below);
  const float drop = beside.below - letters_below * tall.size;  // its foot beside theirs
  Reach reach = put_letters(tall, text, list, {start.x, start.y + drop});
  reach.above = beside.above;
  reach.below = beside.below;
  return reach;
}

Reach Placer::row(const Pen& pen, const Formula& formula, bool display, const ImVec2& start) const {
  Reach inner;
  for (const Formula& part : formula.parts) {
    if (!part.tall) join(inner, reach_of(pen, part, display));
  }
  Reach reach;
  bool after_value = false;
  for (const Formula& part : formula.parts) {
    const float room =
        pen.size * (part.kind == Kind::sign ? room_of(part, after_value) : name_room(part, after_value));
    const ImVec2 at = {start.x + reach.width + room, start.y};
    join(reach, part.tall ? tall_sign(pen, part.text, inner, at) : put(pen, part, display, at));
    const bool comma = part.kind == Kind::sign && part.room == Formula::Room::comma;
    reach.width += 2.0F * room + (comma ? 0.18F * pen.size : 0.0F);
    after_value = part.kind != Kind::sign || part.text == ")" || part.text == "|" || part.text == "\u230B" ||
                  part.text == "\u2016";
  }
  return reach;
}

Reach Placer::fraction(const Pen& pen, const Formula& formula, bool display, const ImVec2& start) const {
  const bool large = display && !formula.small;
  const Pen own = large ? pen : smaller(pen);
  const Reach over = reach_of(own, formula.parts[0], false);
  const Reach under = reach_of(own, formula.parts[1], false);
  const float gap = 0.12F * pen.size;
  const float side = 0.1F * pen.size;
  const float width = std::max(over.width, under.width) + 2.0F * side;
  const float bar = start.y - axis * pen.size;
  if (list != nullptr) {
    (void)put(own, formula.parts[0], false, {start.x + (width - over.width) / 2.0F, bar - gap - over.below});
    (void)put(own, formula.parts[1], false,
              {start.x + (width - under.width) / 2.0F, bar + gap + under.above});
    list->AddLine({start.x + side / 2.0F, bar}, {start.x + width - side / 2.0F, bar}, pen.color,
                  std::max(1.0F, pen.size / 16.0F));
  }
  return {width + side, axis * pen.size + gap + over.below + over.above,
          std::max(0.0F, gap + under.above + under.below - axis * pen.size)};
}

Reach Placer::root(const Pen& pen, const Formula& formula, bool display, const ImVec2& start) const {
  const Reach inner = reach_of(pen, formula.parts[0], display);
  const Reach sign = put_letters(pen, "\u221A", list, start);
  const float top = start.y - std::max(inner.above, letters_above * pen.size);
  if (list != nullptr) {
    (void)put(pen, formula.parts[0], display, {start.x + sign.width, start.y});
    list->AddLine({start.x + 0.92F * sign.width, top}, {start.x + sign.width + inner.width, top}, pen.color,
                  std::max(1.0F, pen.size / 16.0F));
  }
  return {sign.width + inner.width, start.y - top + 1.0F, std::max(inner.below, sign.below)};
}

/// Below and above, as at a sum in a line of its own.
Reach Placer::limits(const Pen& pen, const Formula& formula, const ImVec2& start) const {
  const bool sum = formula.parts[0].kind == Kind::sign;
  Pen base_pen = pen;
  if (sum) base_pen.size *= 1.4F;
  const Pen small = smaller(pen);
  const Reach base = reach_of(base_pen, formula.parts[0], true);
  const Reach under = reach_of(small, formula.parts[1], false);
  const Reach over = reach_of(small, formula.parts[2], false);
  const float width = std::max({base.width, under.width, over.width});
  const auto middle = [&](const Reach& reach) { return start.x + (width - reach.width) / 2.0F; };
  if (list != nullptr) {
    (void)put(base_pen, formula.parts[0], true, {middle(base), start.y});
    (void)put(small, formula.parts[1], false, {middle(under), start.y + base.below + under.above});
    (void)put(small, formula.parts[2], false, {middle(over), start.y - base.above - over.below});
  }
  return {width + 0.15F * pen.size, base.above + over.above + over.below,
          base.below + under.above + under.below};
}

Reach Placer::script(const Pen& pen, const Formula& formula, bool display, const ImVec2& start) const {
  if (formula.limits && display) return limits(pen, formula, start);
  Reach reach = put(pen, formula.parts[0], display, start);
  const Pen small = smaller(pen);
  const float x = start.x + reach.width + 0.04F * pen.size;
  const float down = std::max(0.22F * pen.size, reach.below - 0.1F * pen.size);
  const float up = std::max(0.4F * pen.size, reach.above - 0.4F * pen.size);
  const Reach under = put(small, formula.parts[1], false, {x, start.y + down});
  const Reach over = put(small, formula.parts[2], false, {x, start.y - up});
  reach.width += std::max(under.width, over.width) + 0.08F * pen.size;
  if (under.width > 0.0F) reach.below = std::max(reach.below, down + under.below);
  if (over.width > 0.0F) reach.above = std::max(reach.above, up + over.above);
  return reach;
}

Reach Placer::matrix(const Pen& pen, const Formula& formula, const ImVec2& start) const {
  const float gap = 0.2F * pen.size;
  std::vector<float> widths;
  Reach cell_reach;
  for (const Formula& row_of_cells : formula.parts) {
    widths.resize(std::max(widths.size(), row_of_cells.parts.size()), 0.0F);
    for (std::size_t k = 0; k < row_of_cells.parts.size(); ++k) {
      const Reach cell = reach_of(pen, row_of_cells.parts[k], false);
      widths[k] = std::max(widths[k], cell.width);
      join(cell_reach, cell);
    }
  }
  const float line = cell_reach.above + cell_reach.below + gap;
  const float height = line * static_cast<float>(formula.parts.size());
  const Reach whole = {0.0F, height / 2.0F + axis * pen.size, height / 2.0F - axis * pen.size};
  float x = start.x + tall_sign(pen, "(", whole, start).width;
  for (std::size_t k = 0; k < widths.size(); ++k) {
    float y = start.y - whole.above + gap / 2.0F + cell_reach.above;
    for (const Formula& row_of_cells : formula.parts) {
      if (k < row_of_cells.parts.size()) {
        const float own = reach_of(pen, row_of_cells.parts[k], false).width;
        (void)put(pen, row_of_cells.parts[k], false, {x + (widths[k] - own) / 2.0F, y});
      }
      y += line;
    }
    x += widths[k] + (k + 1 < widths.size() ? pen.size : 0.0F);
  }
  x += tall_sign(pen, ")", whole, {x, start.y}).width;
  return {x - start.x, whole.above, whole.below};
}

Reach Placer::put(const Pen& pen, const Formula& formula, bool display, const ImVec2& start) const {
  switch (formula.kind) {
    case Kind::row:
      return row(pen, formula, display, start);
    case Kind::space:
      return {static_cast<float>(formula.width) * pen.size, 0.0F, 0.0F};
    case Kind::fraction:
      return fraction(pen, formula, display, start);
    case Kind::root:
      return root(pen, formula, display, start);
    case Kind::script:
      return script(pen, formula, display, start);
    case Kind::matrix:
      return matrix(pen, formula, start);
    default:
      return put_letters(pen, formula.text, list, start);
  }
}

}  // namespace

Reach put_letters(const Pen& pen, std::string_view text, ImDrawList* list, const ImVec2& start) {
  const char* end = text.data() + text.size();
  const float width = pen.font->CalcTextSizeA(pen.size, FLT_MAX, 0.0F, text.data(), end).x;
  if (list != nullptr) {
    const int first = list->VtxBuffer.Size;
    const float top = start.y - pen.font->Ascent * pen.size / pen.font->FontSize;
    list->AddText(pen.font, pen.size, {start.x, top}, pen.color, text.data(), end);
    for (int k = first; pen.slanted && k < list->VtxBuffer.Size; ++k) {
      list->VtxBuffer[k].pos.x += slant * (start.y - list->VtxBuffer[k].pos.y);
    }
  }
  return {width + (pen.slanted ? lean * pen.size : 0.0F), letters_above * pen.size, letters_below * pen.size};
}

Reach put_formula(const Pen& pen, const Formula& formula, bool display, ImDrawList* list,
                  const ImVec2& start) {
  return Placer{list}.put(pen, formula, display, start);
}

}  // namespace hsr::window
