#include "lesson/formula.h"
#include "lesson/html.h"

namespace hsr {
namespace {

std::string element(const std::string& name, const std::string& content, const std::string& attributes = {}) {
  return "<" + name + attributes + ">" + content + "</" + name + ">";
}

std::string mathml(const Formula& formula, bool display);

std::string all_parts(const Formula& formula, bool display) {
  std::string text;
  for (const Formula& part : formula.parts) text += mathml(part, display);
  return text;
}

/// As one element, which fractions and scripts need.
std::string single(const Formula& formula, bool display) {
  if (formula.kind == Formula::Kind::row && formula.parts.size() == 1)
    return single(formula.parts[0], display);
  if (formula.kind == Formula::Kind::matrix) return element("mrow", mathml(formula, display));
  return mathml(formula, display);
}

std::string script(const Formula& formula, bool display) {
  const Formula& below = formula.parts[1];
  const Formula& above = formula.parts[2];
  const bool limits = formula.limits && display;
  std::string name = limits ? "munderover" : "msubsup";
  if (above.parts.empty()) name = limits ? "munder" : "msub";
  if (below.parts.empty()) name = limits ? "mover" : "msup";
  std::string content = single(formula.parts[0], display);
  if (!below.parts.empty()) content += single(below, false);
  if (!above.parts.empty()) content += single(above, false);
  return element(name, content);
}

std::string sign(const Formula& formula) {
  return element("mo", html_text(formula.text), formula.tall ? " stretchy=\"true\"" : " stretchy=\"false\"");
}

std::string matrix(const Formula& formula) {
  std::string rows;
  for (const Formula& row : formula.parts) {
    std::string cells;
    for (const Formula& cell : row.parts) cells += element("mtd", mathml(cell, false));
    rows += element("mtr", cells);
  }
  return "<mo stretchy=\"true\">(</mo>" + element("mtable", rows) + "<mo stretchy=\"true\">)</mo>";
}

std::string mathml(const Formula& formula, bool display) {
  using Kind = Formula::Kind;
  switch (formula.kind) {
    case Kind::row:
      return element("mrow", all_parts(formula, display));
    case Kind::identifier: {
      // A single letter would be slanted.
      const bool letter = formula.upright && formula.text.size() == 1;
      return element("mi", html_text(formula.text), letter ? " mathvariant=\"normal\"" : "");
    }
    case Kind::number:
      return element("mn", html_text(formula.text));
    case Kind::sign:
      return sign(formula);
    case Kind::words:
      return element("mtext", html_text(formula.text));
    case Kind::space:
      return "<mspace width=\"" + std::to_string(formula.width) + "em\"></mspace>";
    case Kind::fraction: {
      const bool large = display && !formula.small;
      const std::string fraction =
          element("mfrac", single(formula.parts[0], large) + single(formula.parts[1], large));
      return formula.small ? element("mstyle", fraction, " displaystyle=\"false\"") : fraction;
    }
    case Kind::root:
      return element("msqrt", single(formula.parts[0], display));
    case Kind::script:
      return script(formula, display);
    case Kind::matrix:
      return matrix(formula);
  }
  return {};
}

}  // namespace

std::string formula_mathml(const Formula& formula, bool display) {
  return element("math", mathml(formula, display), display ? " display=\"block\"" : "");
}

}  // namespace hsr
