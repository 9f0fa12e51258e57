#include "lesson/document.h"

#include <md4c.h>

#include <algorithm>
#include <exception>

#include "scene/errors.h"

namespace hsr {
namespace {

constexpr std::string_view script_language = "hsr-script";
constexpr std::string_view details_begin = "<details><summary>";
constexpr std::string_view details_middle = "</summary>";
constexpr std::string_view details_end = "</details>";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \n");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \n") + 1 - begin);
}

std::string text_of(const MD_ATTRIBUTE& attribute) { return {attribute.text, attribute.size}; }

/// Makes the tree of what the parser tells. What it tells of is open until it is told to be left.
class Builder {
 public:
  explicit Builder(std::string_view markdown) : markdown_(markdown) { begin(Block::Kind::item); }

  void enter(MD_BLOCKTYPE type, const void* detail) {
    end_loose_text();
    switch (type) {
      case MD_BLOCK_DOC:
      case MD_BLOCK_THEAD:
      case MD_BLOCK_TBODY:
        break;
      case MD_BLOCK_H:
        begin(Block::Kind::heading, static_cast<int>(static_cast<const MD_BLOCK_H_DETAIL*>(detail)->level));
        break;
      case MD_BLOCK_P:
        begin(Block::Kind::paragraph);
        break;
      case MD_BLOCK_UL:
        begin(Block::Kind::list);
        break;
      case MD_BLOCK_OL:
        begin(Block::Kind::list, static_cast<int>(static_cast<const MD_BLOCK_OL_DETAIL*>(detail)->start));
        break;
      case MD_BLOCK_LI:
        begin(Block::Kind::item);
        break;
      case MD_BLOCK_CODE: {
        const bool script =
            text_of(static_cast<const MD_BLOCK_CODE_DETAIL*>(detail)->lang) == script_language;
        begin(script ? Block::Kind::script : Block::Kind::code);
        break;
      }
      case MD_BLOCK_TABLE:
        begin(Block::Kind::table);
        break;
      case MD_BLOCK_TR:
        begin(Block::Kind::row);
        break;
      case MD_BLOCK_TH:
      case MD_BLOCK_TD:
        begin(Block::Kind::cell);
        break;
      case MD_BLOCK_HTML:
        html_.clear();
        break;
      default:
        throw InputError("quotations and rules are not known here");
    }
  }

  void leave(MD_BLOCKTYPE type) {
    end_loose_text();
    if (type == MD_BLOCK_DOC || type == MD_BLOCK_THEAD || type == MD_BLOCK_TBODY) return;
    if (type == MD_BLOCK_HTML) return take_html(trimmed(html_));
    if (open_.back().kind == Block::Kind::details) throw InputError("details are not closed");
    end();
  }

  void enter(MD_SPANTYPE type, const void* detail) {
    switch (type) {
      case MD_SPAN_EM:
        style_.emphasis = true;
        break;
      case MD_SPAN_STRONG:
        style_.strong = true;
        break;
      case MD_SPAN_A:
        style_.address = text_of(static_cast<const MD_SPAN_A_DETAIL*>(detail)->href);
        break;
      case MD_SPAN_IMG:
        begin_run(Inline::Kind::image);
        run_.address = text_of(static_cast<const MD_SPAN_IMG_DETAIL*>(detail)->src);
        break;
      case MD_SPAN_CODE:
        begin_run(Inline::Kind::code);
        break;
      case MD_SPAN_LATEXMATH:
      case MD_SPAN_LATEXMATH_DISPLAY:
        begin_run(Inline::Kind::formula);
        run_.display = type == MD_SPAN_LATEXMATH_DISPLAY;
        break;
      default:
        throw InputError("a kind of text that is not known here");
    }
  }

  void leave(MD_SPANTYPE type) {
    switch (type) {
      case MD_SPAN_EM:
        style_.emphasis = false;
        break;
      case MD_SPAN_STRONG:
        style_.strong = false;
        break;
      case MD_SPAN_A:
        style_.address.clear();
        break;
      default:
        if (run_.kind == Inline::Kind::formula)
          run_.formula = std::make_shared<const Formula>(parse_formula(run_.text));
        words().push_back(std::move(run_));
        in_run_ = false;
        break;
    }
  }

  void text(MD_TEXTTYPE type, std::string_view text) {
    Block& block = open_.back();
    if (type == MD_TEXT_HTML) {
      if (in_loose_text_ || block.kind == Block::Kind::paragraph || block.kind == Block::Kind::cell)
        throw InputError("HTML within a text: " + std::string(text));
      html_ += text;
    } else if (block.kind == Block::Kind::code || block.kind == Block::Kind::script) {
      if (block.text.empty()) block.line = line_of(text);
      block.text += text;
    } else if (type == MD_TEXT_BR) {
      words().push_back({Inline::Kind::line_break, {}, {}, {}, false, false, false});
    } else if (type == MD_TEXT_ENTITY || type == MD_TEXT_NULLCHAR) {
      throw InputError("write the letter itself, not " + std::string(text));
    } else {
      add_text(type == MD_TEXT_SOFTBR ? " " : text);
    }
  }

  std::vector<Block> blocks() {
    end_loose_text();
    if (open_.size() != 1) throw InputError("details are not closed");
    return std::move(open_.front().parts);
  }

 private:
  void begin(Block::Kind kind, int level = 0) {
    Block& block = open_.emplace_back();
    block.kind = kind;
    block.level = level;
  }

  void end() {
    Block block = std::move(open_.back());
    open_.pop_back();
    open_.back().parts.push_back(std::move(block));
  }

  /// The words of short list items stand in no paragraph; here they do.
  std::vector<Inline>& words() {
    const Block::Kind kind = open_.back().kind;
    if (kind == Block::Kind::item || kind == Block::Kind::details) {
      begin(Block::Kind::paragraph);
      in_loose_text_ = true;
    }
    return open_.back().words;
  }

  void end_loose_text() {
    if (in_loose_text_) end();
    in_loose_text_ = false;
  }

  void begin_run(Inline::Kind kind) {
    run_ = style_;
    run_.kind = kind;
    in_run_ = true;
  }

  void add_text(std::string_view text) {
    if (in_run_) {
      run_.text += text;
      return;
    }
    std::vector<Inline>& all = words();
    const bool same = !all.empty() && all.back().kind == Inline::Kind::text &&
                      all.back().strong == style_.strong && all.back().emphasis == style_.emphasis &&
                      all.back().address == style_.address;
    if (!same) all.push_back(style_);
    all.back().text += text;
  }

  void take_html(std::string_view html) {
    if (html == details_end) {
      if (open_.back().kind != Block::Kind::details)
        throw InputError("there are no details to be closed here");
      return end();
    }
    const bool begins = html.starts_with(details_begin) && html.ends_with(details_middle) &&
                        html.find('\n') == std::string_view::npos;
    if (!begins) throw InputError("HTML that is not known here: " + std::string(html));
    begin(Block::Kind::details);
    html.remove_prefix(details_begin.size());
    html.remove_suffix(details_middle.size());
    open_.back().text = html;
  }

  /// The parser hands out parts of the text itself.
  int line_of(std::string_view text) const {
    const auto before =
        std::string_view(markdown_.data(), static_cast<std::size_t>(text.data() - markdown_.data()));
    return 1 + static_cast<int>(std::ranges::count(before, '\n'));
  }

  std::string_view markdown_;
  std::vector<Block> open_;  // the document first
  bool in_loose_text_ = false;
  Inline style_;
  Inline run_;
  bool in_run_ = false;
  std::string html_;
};

/// The parser is written in C: no exception may pass through it.
struct Parsing {
  Builder builder;
  std::exception_ptr error;
};

template <class Work>
int guarded(void* parsing, Work work) {
  auto& self = *static_cast<Parsing*>(parsing);
  if (self.error) return 1;  // the parser tells of the end of what is open all the same
  try {
    work(self.builder);
    return 0;
  } catch (...) {
    self.error = std::current_exception();
    return 1;
  }
}

}  // namespace

Document read_document(std::string_view markdown, const std::string& source) {
  MD_PARSER parser = {};
  parser.flags = MD_FLAG_TABLES | MD_FLAG_LATEXMATHSPANS;
  parser.enter_block = [](MD_BLOCKTYPE type, void* detail, void* parsing) {
    return guarded(parsing, [&](Builder& builder) { builder.enter(type, detail); });
  };
  parser.leave_block = [](MD_BLOCKTYPE type, void*, void* parsing) {
    return guarded(parsing, [&](Builder& builder) { builder.leave(type); });
  };
  parser.enter_span = [](MD_SPANTYPE type, void* detail, void* parsing) {
    return guarded(parsing, [&](Builder& builder) { builder.enter(type, detail); });
  };
  parser.leave_span = [](MD_SPANTYPE type, void*, void* parsing) {
    return guarded(parsing, [&](Builder& builder) { builder.leave(type); });
  };
  parser.text = [](MD_TEXTTYPE type, const MD_CHAR* text, MD_SIZE size, void* parsing) {
    return guarded(parsing, [&](Builder& builder) { builder.text(type, {text, size}); });
  };
  Parsing parsing = {Builder(markdown), nullptr};
  Document document;
  try {
    const int result = md_parse(markdown.data(), static_cast<MD_SIZE>(markdown.size()), &parser, &parsing);
    if (parsing.error) std::rethrow_exception(parsing.error);
    if (result != 0) throw InputError("it cannot be read as Markdown");
    document.blocks = parsing.builder.blocks();
  } catch (const InputError& error) {
    throw InputError(source + ": " + error.what());
  }
  const auto title = std::ranges::find(document.blocks, Block::Kind::heading, &Block::kind);
  if (title != document.blocks.end()) document.title = plain_text(title->words);
  return document;
}

std::string plain_text(const std::vector<Inline>& words) {
  std::string text;
  for (const Inline& word : words) {
    if (word.kind == Inline::Kind::formula) {
      text += formula_text(*word.formula);
    } else {
      text += word.kind == Inline::Kind::line_break ? " " : word.text;
    }
  }
  return text;
}

}  // namespace hsr
