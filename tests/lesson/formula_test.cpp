#include "lesson/formula.h"

#include <doctest/doctest.h>

#include <string>

#include "lesson/course.h"
#include "scene/errors.h"

namespace hsr::test {
namespace {

std::string text(const std::string& tex) { return formula_text(parse_formula(tex)); }
std::string mathml(const std::string& tex) { return formula_mathml(parse_formula(tex), false); }

/// Calls visit for every formula of the blocks.
template <class Visit>
void visit_formulas(const std::vector<Block>& blocks, Visit visit) {
  for (const Block& block : blocks) {
    for (const Inline& word : block.words) {
      if (word.kind == Inline::Kind::formula) visit(word);
    }
    visit_formulas(block.parts, visit);
  }
}

/// Whether every element of a piece of XML is closed in its order.
bool well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = xml.substr(at + 1, end - at - 1);
    if (tag[0] != '/') {
      open.push_back(tag.substr(0, tag.find(' ')));
    } else if (open.empty() || open.back() != tag.substr(1)) {
      return false;
    } else {
      open.pop_back();
    }
  }
  return open.empty();
}

/// How many elements of that name there are.
int count(const std::string& xml, const std::string& name) {
  int found = 0;
  for (std::size_t at = xml.find("<" + name); at != std::string::npos; at = xml.find("<" + name, at + 1)) {
    const char next = xml[at + 1 + name.size()];
    if (next == '>' || next == ' ') ++found;
  }
  return found;
}

}  // namespace

TEST_CASE("lesson: a formula in one line says the same") {
  CHECK(text("x^2 + y_1") == "x\u00B2 + y\u2081");
  CHECK(text("-1") == "\u22121");
  CHECK(text("a \\cdot (-b)") == "a \u00B7 (\u2212b)");
  CHECK(text("\\frac{a + b}{c}") == "(a + b)/c");
  CHECK(text("\\tfrac12") == "1/2");
  CHECK(text("\\sqrt{a^2 + b^2}") == "\u221A(a\u00B2 + b\u00B2)");
  CHECK(text("2^{-24}") == "2\u207B\u00B2\u2074");
  CHECK(text("x_{\\text{back}}^{\\max}") == "x_back^max");
  CHECK(text("28{,}800{,}000") == "28,800,000");
  CHECK(text("\\lfloor x_r \\rfloor") == "\u230Ax_r\u230B");
  CHECK(text("\\max(a, b)") == "max(a, b)");
  CHECK(text("n \\log n") == "n log n");
  CHECK(text("\\begin{pmatrix} a & b \\\\ c & d \\end{pmatrix}") == "(a, b; c, d)");
}

TEST_CASE("lesson: a formula in MathML has the elements that it needs") {
  CHECK(mathml("x") == "<math><mrow><mi>x</mi></mrow></math>");
  CHECK(mathml("a < b").find("<mo stretchy=\"false\">&lt;</mo>") != std::string::npos);
  CHECK(mathml("x_i^2").find("<msubsup><mi>x</mi><mi>i</mi><mn>2</mn></msubsup>") != std::string::npos);
  CHECK(mathml("x^{a + b}").find("<msup><mi>x</mi><mrow>") != std::string::npos);
  CHECK(mathml("\\frac{1}{2}").find("<mfrac><mn>1</mn><mn>2</mn></mfrac>") != std::string::npos);
  CHECK(formula_mathml(parse_formula("\\sum_k"), true).find("<munder>") != std::string::npos);
  CHECK(mathml("\\sum_k").find("<msub>") != std::string::npos);
  CHECK(count(mathml("\\begin{pmatrix} a & b \\\\ c & d \\end{pmatrix}"), "mtd") == 4);
}

TEST_CASE("lesson: a formula with something unknown is an error, and never silently wrong") {
  for (const char* tex : {"\\theta", "\\unknown{x}", "x'", "{x", "x}", "\\frac{1}", "x^", "x^a^b",
                          "\\left( x", "\\begin{matrix} x \\end{matrix}", "\\begin{pmatrix} x", "\\text{a",
                          "a # b", "a [ b", "\\right)", "a & b", "\\mathrm{\\pi}"}) {
    CAPTURE(tex);
    CHECK_THROWS_AS((void)parse_formula(tex), InputError);
  }
}

TEST_CASE("lesson: every formula of every lesson is well-formed, and none is lost") {
  int formulas = 0;
  for (const Lesson& lesson : lesson_catalog()) {
    CAPTURE(lesson.folder);
    visit_formulas(open_lesson(lesson).document.blocks, [&](const Inline& word) {
      CAPTURE(word.text);
      ++formulas;
      const std::string xml = formula_mathml(*word.formula, word.display);
      CAPTURE(xml);
      CHECK(well_formed(xml));
      CHECK_FALSE(formula_text(*word.formula).empty());
      // As many scripts, fractions and roots as the TeX has.
      int scripts = 0;
      for (const char letter : word.text) scripts += letter == '_' || letter == '^' ? 1 : 0;
      const int both = count(xml, "msubsup") + count(xml, "munderover");
      CHECK(count(xml, "msub") + count(xml, "msup") + count(xml, "munder") + count(xml, "mover") + 2 * both ==
            scripts);
    });
  }
  CHECK(formulas > 150);
}

}  // namespace hsr::test
