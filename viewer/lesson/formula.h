#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hsr {

/// A formula, as a tree. The lessons write formulas in a small part of TeX; from the tree they are shown in
/// the window, as MathML in a book, and as a line of text.
struct Formula {
  enum class Kind {
    row,         ///< its parts side by side
    identifier,  ///< a variable, or the name of a function
    number,
    sign,      ///< an operator, a relation, a bracket, a comma
    words,     ///< plain text
    space,     ///< `width` ems wide
    fraction,  ///< parts: above, below
    root,      ///< of its one part
    script,    ///< parts: what bears them, below, above; an empty row where there is none
    matrix     ///< parts: rows of cells, all in round brackets
  };
  /// How much room a sign takes.
  enum class Room { none, binary, relation, comma };

  Kind kind = Kind::row;
  std::string text;        ///< of a leaf, in UTF-8
  Room room = Room::none;  ///< of a sign
  double width = 0.0;      ///< of a space
  bool upright = false;    ///< identifiers: the name of a function
  bool tall = false;       ///< signs: as tall as what stands beside it (\left, \right)
  bool small = false;      ///< fractions: as in a line of text (\tfrac)
  bool limits = false;     ///< scripts: below and above their bearer where there is room (\sum, \max)
  std::vector<Formula> parts;
};

/// Reads the TeX between dollars. Throws InputError for whatever it does not know: a command, a brace or
/// bracket that is not closed, a letter that is none of a formula.
Formula parse_formula(std::string_view tex);

/// MathML Core, as an element of HTML. With `display` it stands in a line of its own.
std::string formula_mathml(const Formula& formula, bool display);

/// In one line of Unicode, such as "w²/n ≈ 1/(f − n)": for copying, scripts and readers that speak.
std::string formula_text(const Formula& formula);

}  // namespace hsr
