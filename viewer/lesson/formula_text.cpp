#include <array>
#include <string_view>

#include "lesson/formula.h"

namespace hsr {
namespace {

using Kind = Formula::Kind;

struct Raised {
  std::string_view plain, below, above;
};

/// What Unicode has below and above the line; empty where it has none.
constexpr std::array raised = {
    Raised{"0", "\u2080", "\u2070"}, Raised{"1", "\u2081", "\u00B9"}, Raised{"2", "\u2082", "\u00B2"},
    Raised{"3", "\u2083", "\u00B3"}, Raised{"4", "\u2084", "\u2074"}, Raised{"5", "\u2085", "\u2075"},
    Raised{"6", "\u2086", "\u2076"}, Raised{"7", "\u2087", "\u2077"}, Raised{"8", "\u2088", "\u2078"},
    Raised{"9", "\u2089", "\u2079"}, Raised{"+", "\u208A", "\u207A"}, Raised{"\u2212", "\u208B", "\u207B"},
    Raised{"a", "\u2090", {}},       Raised{"k", "\u2096", {}},       Raised{"m", "\u2098", {}},
    Raised{"n", "\u2099", "\u207F"}, Raised{"p", "\u209A", {}},       Raised{"s", "\u209B", {}},
};

std::string plain(const Formula& formula);

std::string all_parts(const Formula& formula) {
  std::string text;
  bool after_value = false;  // a sign between values has room, one before a value has none
  for (const Formula& part : formula.parts) {
    const std::string own = plain(part);
    const bool binary = part.kind == Kind::sign && part.room == Formula::Room::binary;
    const bool relation = part.kind == Kind::sign && part.room == Formula::Room::relation;
    if (relation || (binary && after_value)) {
      text += " " + own + " ";
    } else {
      const Formula& bearer = part.kind == Kind::script ? part.parts[0] : part;
      const bool name = bearer.kind == Kind::identifier && bearer.upright && bearer.text.size() > 1;
      const bool bracket = &part != &formula.parts.back() && (&part + 1)->text == "(";
      text += (name && after_value ? " " : "") + own + (name && !bracket ? " " : "");
      if (part.kind == Kind::sign && part.room == Formula::Room::comma) text += " ";
    }
    after_value = part.kind != Kind::sign || own == ")" || own == "|" || own == "\u230B" || own == "\u2016";
  }
  return text;
}

/// In brackets if it is more than one thing.
std::string as_one(const Formula& formula) {
  if (formula.kind == Kind::row && formula.parts.size() == 1) return as_one(formula.parts[0]);
  const bool many = formula.kind == Kind::row || formula.kind == Kind::fraction;
  return many ? "(" + plain(formula) + ")" : plain(formula);
}

/// In raised or lowered letters, or empty where a letter has none.
std::string moved(const std::string& text, bool up) {
  std::string result;
  for (std::string_view rest = text; !rest.empty();) {
    const Raised* found = nullptr;
    for (const Raised& each : raised) {
      if (rest.starts_with(each.plain)) found = &each;
    }
    if (found == nullptr || (up ? found->above : found->below).empty()) return {};
    result += up ? found->above : found->below;
    rest.remove_prefix(found->plain.size());
  }
  return result;
}

std::string script(const Formula& formula, bool up) {
  if (formula.parts.empty()) return {};
  const std::string letters = moved(plain(formula), up);
  return letters.empty() ? (up ? "^" : "_") + as_one(formula) : letters;
}

std::string matrix(const Formula& formula) {
  std::string text = "(";
  for (const Formula& row : formula.parts) {
    text += text.size() > 1 ? "; " : "";
    for (std::size_t k = 0; k < row.parts.size(); ++k) text += (k > 0 ? ", " : "") + plain(row.parts[k]);
  }
  return text + ")";
}

std::string plain(const Formula& formula) {
  switch (formula.kind) {
    case Kind::row:
      return all_parts(formula);
    case Kind::space:
      return " ";
    case Kind::fraction:
      return as_one(formula.parts[0]) + "/" + as_one(formula.parts[1]);
    case Kind::root:
      return "\u221A" + as_one(formula.parts[0]);
    case Kind::script:
      return plain(formula.parts[0]) + script(formula.parts[1], false) + script(formula.parts[2], true);
    case Kind::matrix:
      return matrix(formula);
    default:
      return formula.text;
  }
}

}  // namespace

std::string formula_text(const Formula& formula) {
  // Rooms that meet are one.
  std::string text;
  for (const char letter : plain(formula)) {
    if (letter == ' ' && (text.empty() || text.back() == ' ')) continue;
    text += letter;
  }
  if (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

}  // namespace hsr
