#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/formula.h"

namespace hsr {

/// A stretch of a paragraph.
struct Inline {
  enum class Kind { text, code, formula, image, line_break };
  Kind kind = Kind::text;
  std::string text;                        ///< an image's: what is to be seen on it; a formula's: its TeX
  std::string address;                     ///< of a link, or of an image
  std::shared_ptr<const Formula> formula;  ///< of a formula
  bool display = false;                    ///< the formula stands in a line of its own
  bool strong = false;
  bool emphasis = false;
};

/// A piece of a document.
struct Block {
  enum class Kind { heading, paragraph, code, script, list, item, table, row, cell, details };
  Kind kind = Kind::paragraph;
  int level = 0;              ///< headings: 1 to 6; lists: the first number, or 0 for bullets
  std::vector<Inline> words;  ///< of headings, paragraphs and cells
  std::string text;           ///< the lines of code and scripts; of details, what stands on the fold
  int line = 0;               ///< where the first line of a script stands in the file, from 1
  std::vector<Block>
      parts;  ///< a list's items, a table's rows (its head first), a row's cells, what is folded
};

/// A lesson's text: Markdown with tables, formulas between dollars, scripts of the viewer in blocks marked
/// hsr-script, and answers to be unfolded, each between the lines <details><summary>WORDS</summary> and
/// </details> with an empty line round them.
struct Document {
  std::string title;  ///< the first heading
  std::vector<Block> blocks;
};

/// Reads such a text. Throws InputError, with `source`, for other HTML and for formulas that it does not
/// know.
Document read_document(std::string_view markdown, const std::string& source);

/// The words alone, without how they are set.
std::string plain_text(const std::vector<Inline>& words);

}  // namespace hsr
