#include "lesson/formula.h"

#include <algorithm>
#include <array>

#include "scene/errors.h"

namespace hsr {
namespace {

using Kind = Formula::Kind;
using Room = Formula::Room;

Formula leaf(Kind kind, std::string_view text, Room room = Room::none) {
  Formula formula;
  formula.kind = kind;
  formula.text = text;
  formula.room = room;
  return formula;
}

/// A command that stands for one sign or letter.
struct Named {
  std::string_view name;
  Kind kind;
  std::string_view text;
  Room room;
};

constexpr std::array named = {
    Named{"cdot", Kind::sign, "\u00B7", Room::binary},
    Named{"times", Kind::sign, "\u00D7", Room::binary},
    Named{"pm", Kind::sign, "\u00B1", Room::binary},
    Named{"approx", Kind::sign, "\u2248", Room::relation},
    Named{"le", Kind::sign, "\u2264", Room::relation},
    Named{"ge", Kind::sign, "\u2265", Room::relation},
    Named{"ne", Kind::sign, "\u2260", Room::relation},
    Named{"gg", Kind::sign, "\u226B", Room::relation},
    Named{"leftarrow", Kind::sign, "\u2190", Room::relation},
    Named{"sum", Kind::sign, "\u2211", Room::none},
    Named{"prod", Kind::sign, "\u220F", Room::none},
    Named{"dots", Kind::sign, "\u2026", Room::none},
    Named{"lfloor", Kind::sign, "\u230A", Room::none},
    Named{"rfloor", Kind::sign, "\u230B", Room::none},
    Named{"lVert", Kind::sign, "\u2016", Room::none},
    Named{"rVert", Kind::sign, "\u2016", Room::none},
    Named{"infty", Kind::number, "\u221E", Room::none},
    Named{"alpha", Kind::identifier, "\u03B1", Room::none},
    Named{"varepsilon", Kind::identifier, "\u03B5", Room::none},
    Named{"varphi", Kind::identifier, "\u03C6", Room::none},
    Named{"Delta", Kind::identifier, "\u0394", Room::none},
};

constexpr std::array<std::string_view, 4> functions = {"max", "min", "log", "tan"};
constexpr std::array<std::string_view, 4> with_limits = {"max", "min", "sum", "prod"};

struct NamedSpace {
  std::string_view name;
  double width;
};
constexpr std::array spaces = {NamedSpace{",", 3.0 / 18.0}, NamedSpace{";", 5.0 / 18.0},
                               NamedSpace{" ", 0.25}, NamedSpace{"quad", 1.0}, NamedSpace{"qquad", 2.0}};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

class Parser {
 public:
  explicit Parser(std::string_view tex) : whole_(tex), rest_(tex) {}

  Formula all() {
    Formula row = read_row();
    if (!rest_.empty()) fail("there is too much from \"" + std::string(rest_) + "\" on");
    return row;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError("the formula \"" + std::string(whole_) + "\": " + what);
  }

  void skip_blanks() {
    while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\n')) rest_.remove_prefix(1);
  }

  /// Whether the row that is being read ends here.
  bool at_end() {
    skip_blanks();
    return rest_.empty() || rest_[0] == '}' || rest_[0] == '&' || rest_.starts_with("\\\\") ||
           rest_.starts_with("\\right") || rest_.starts_with("\\end");
  }

  void take(std::string_view text) {
    skip_blanks();
    if (!rest_.starts_with(text))
      fail("\"" + std::string(text) + "\" is missing before \"" + std::string(rest_) + "\"");
    rest_.remove_prefix(text.size());
  }

  Formula read_row() {
    Formula row;
    while (!at_end()) row.parts.push_back(with_scripts(read_atom(true)));
    return row;
  }

  Formula with_scripts(Formula base) {
    const bool limits = base.limits;
    Formula below;
    Formula above;
    bool any = false;
    for (skip_blanks(); !rest_.empty() && (rest_[0] == '_' || rest_[0] == '^'); skip_blanks()) {
      Formula& script = rest_[0] == '_' ? below : above;
      rest_.remove_prefix(1);
      if (!script.parts.empty()) fail("two scripts at the same place");
      script.parts.push_back(read_argument());
      any = true;
    }
    if (!any) return base;
    Formula script;
    script.kind = Kind::script;
    script.limits = limits;
    script.parts = {std::move(base), std::move(below), std::move(above)};
    return script;
  }

  /// A group in braces, or the next sign alone.
  Formula read_argument() {
    skip_blanks();
    return read_atom(false);
  }

  Formula read_group() {
    take("{");
    Formula row = read_row();
    take("}");
    return row;
  }

  /// The letters between braces as they are.
  std::string_view read_words() {
    take("{");
    const std::size_t end = rest_.find_first_of("{}\\");
    if (end == std::string_view::npos || rest_[end] != '}')
      fail("words that are not closed, or hold a command");
    const std::string_view words = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return words;
  }

  Formula read_number(bool whole) {
    std::string text;
    while (!rest_.empty()) {
      if (is_digit(rest_[0]) || (rest_[0] == '.' && rest_.size() > 1 && is_digit(rest_[1]))) {
        text += rest_[0];
        rest_.remove_prefix(1);
      } else if (rest_.starts_with("{,}")) {
        text += ',';
        rest_.remove_prefix(3);
      } else {
        break;
      }
      if (!whole) break;
    }
    return leaf(Kind::number, text);
  }

  Formula read_sign() {
    const char sign = rest_[0];
    rest_.remove_prefix(1);
    switch (sign) {
      case '+':
        return leaf(Kind::sign, "+", Room::binary);
      case '-':
        return leaf(Kind::sign, "\u2212", Room::binary);
      case '=':
      case '<':
      case '>':
        return leaf(Kind::sign, std::string_view(&sign, 1), Room::relation);
      case ',':
      case ';':
        return leaf(Kind::sign, std::string_view(&sign, 1), Room::comma);
      case '(':
      case ')':
      case '|':
      case '/':
      case '.':
        return leaf(Kind::sign, std::string_view(&sign, 1));
      default:
        fail("\"" + std::string(1, sign) + "\" is not known");
    }
  }

  /// With `whole`, a number takes all its digits.
  Formula read_atom(bool whole) {
    if (rest_.empty()) fail("something is missing at its end");
    const char first = rest_[0];
    if (first == '{') return read_group();
    if (first == '\\') return read_command();
    if (is_digit(first)) return read_number(whole);
    if (is_letter(first)) {
      rest_.remove_prefix(1);
      return leaf(Kind::identifier, std::string_view(&first, 1));
    }
    return read_sign();
  }

  Formula read_command() {
    rest_.remove_prefix(1);
    std::size_t length = 0;
    while (length < rest_.size() && is_letter(rest_[length])) ++length;
    const std::string_view name = rest_.substr(0, std::max<std::size_t>(length, 1));
    rest_.remove_prefix(name.size());
    if (name == "frac" || name == "tfrac") return read_fraction(name == "tfrac");
    if (name == "sqrt") return parent(Kind::root, {read_argument()});
    if (name == "text") return leaf(Kind::words, read_words());
    if (name == "left") return read_fenced();
    if (name == "begin") return read_matrix();
    if (name == "mathrm") {
      Formula identifier = leaf(Kind::identifier, read_words());
      identifier.upright = true;
      return identifier;
    }
    return read_named(name);
  }

  Formula read_named(std::string_view name) {
    if (const auto space = std::ranges::find(spaces, name, &NamedSpace::name); space != spaces.end()) {
      Formula formula;
      formula.kind = Kind::space;
      formula.width = space->width;
      return formula;
    }
    Formula formula;
    if (std::ranges::find(functions, name) != functions.end()) {
      formula = leaf(Kind::identifier, name);
      formula.upright = true;
    } else if (const auto found = std::ranges::find(named, name, &Named::name); found != named.end()) {
      formula = leaf(found->kind, found->text, found->room);
    } else {
      fail("the command \\" + std::string(name) + " is not known");
    }
    formula.limits = std::ranges::find(with_limits, name) != with_limits.end();
    return formula;
  }

  static Formula parent(Kind kind, std::vector<Formula> parts) {
    Formula formula;
    formula.kind = kind;
    formula.parts = std::move(parts);
    return formula;
  }

  Formula read_fraction(bool small) {
    Formula above = read_argument();
    Formula below = read_argument();
    Formula fraction = parent(Kind::fraction, {std::move(above), std::move(below)});
    fraction.small = small;
    return fraction;
  }

  Formula read_fenced() {
    skip_blanks();
    Formula open = read_sign();
    Formula row = read_row();
    take("\\right");
    skip_blanks();
    Formula close = read_sign();
    open.tall = close.tall = true;
    return parent(Kind::row, {std::move(open), std::move(row), std::move(close)});
  }

  Formula read_matrix() {
    take("{pmatrix}");
    Formula matrix = parent(Kind::matrix, {});
    matrix.parts.emplace_back();
    while (true) {
      matrix.parts.back().parts.push_back(read_row());
      if (rest_.starts_with("&")) {
        rest_.remove_prefix(1);
      } else if (rest_.starts_with("\\\\")) {
        rest_.remove_prefix(2);
        matrix.parts.emplace_back();
      } else {
        break;
      }
    }
    take("\\end");
    take("{pmatrix}");
    return matrix;
  }

  std::string_view whole_;
  std::string_view rest_;
};

}  // namespace

Formula parse_formula(std::string_view tex) { return Parser(tex).all(); }

}  // namespace hsr
