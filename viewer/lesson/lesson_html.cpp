#include "lesson/lesson_html.h"

#include <algorithm>

#include "lesson/html.h"

namespace hsr {
namespace {

constexpr std::string_view to_root = "../../";

/// Where a lesson's link leads in the book; empty if it leads out of it to something that the book has not.
std::string book_address(const std::string& address) {
  if (!address.starts_with(to_root)) return address;
  const std::string path = address.substr(to_root.size());
  const bool carried = std::ranges::find(carried_files(), path, &CarriedFile::path) != carried_files().end();
  return carried ? source_page_name(path) : std::string();
}

class Writer {
 public:
  explicit Writer(const OpenLesson& lesson) : lesson_(lesson) {}

  std::string blocks(const std::vector<Block>& blocks) {
    std::string html;
    for (const Block& each : blocks) html += block(each);
    return html;
  }

 private:
  std::string block(const Block& block) {
    switch (block.kind) {
      case Block::Kind::heading: {
        const std::string name = "h" + std::to_string(block.level);
        return "<" + name + " id=\"h" + std::to_string(headings_++) + "\">" + words(block.words) + "</" +
               name + ">\n";
      }
      case Block::Kind::paragraph:
        return paragraph(block);
      case Block::Kind::code:
        return "<pre><code>" + html_text(block.text) + "</code></pre>\n";
      case Block::Kind::script:
        return "<details class=\"script\"><summary>What the viewer does here</summary><pre><code>" +
               html_text(block.text) + "</code></pre></details>\n";
      case Block::Kind::list:
        return list(block);
      case Block::Kind::table:
        return table(block);
      case Block::Kind::details:
        return "<details class=\"answer\"><summary>" + html_text(block.text) + "</summary>\n" +
               blocks(block.parts) + "</details>\n";
      default:
        return {};
    }
  }

  std::string paragraph(const Block& block) {
    const bool figure = block.words.size() == 1 && block.words[0].kind == Inline::Kind::image;
    if (!figure) return "<p>" + words(block.words) + "</p>\n";
    const Inline& image = block.words[0];
    const std::string text = html_text(image.text);
    return "<figure><img src=\"" + html_text(std::string(lesson_.lesson->folder) + "/" + image.address) +
           "\" alt=\"" + text + "\"><figcaption>" + text + "</figcaption></figure>\n";
  }

  std::string list(const Block& block) {
    const std::string name = block.level > 0 ? "ol" : "ul";
    std::string html = "<" + name;
    if (block.level > 1) html += " start=\"" + std::to_string(block.level) + "\"";
    html += ">\n";
    for (const Block& item : block.parts) html += "<li>" + blocks(item.parts) + "</li>\n";
    return html + "</" + name + ">\n";
  }

  std::string table(const Block& block) {
    std::string html = "<table>\n";
    for (const Block& row : block.parts) {
      const std::string name = &row == &block.parts[0] ? "th" : "td";
      html += "<tr>";
      for (const Block& cell : row.parts) html += "<" + name + ">" + words(cell.words) + "</" + name + ">";
      html += "</tr>\n";
    }
    return html + "</table>\n";
  }

  static std::string words(const std::vector<Inline>& runs) {
    std::string html;
    for (const Inline& run : runs) html += word(run);
    return html;
  }

  static std::string word(const Inline& run) {
    std::string html;
    switch (run.kind) {
      case Inline::Kind::text:
        html = html_text(run.text);
        break;
      case Inline::Kind::code:
        html = "<code>" + html_text(run.text) + "</code>";
        break;
      case Inline::Kind::formula:
        html = formula_mathml(*run.formula, run.display);
        break;
      case Inline::Kind::line_break:
        html = "<br>";
        break;
      case Inline::Kind::image:
        break;
    }
    if (run.emphasis) html = "<em>" + html + "</em>";
    if (run.strong) html = "<strong>" + html + "</strong>";
    const std::string address = book_address(run.address);
    return address.empty() ? html : "<a href=\"" + html_text(address) + "\">" + html + "</a>";
  }

  const OpenLesson& lesson_;
  int headings_ = 0;
};

}  // namespace

std::string page_name(const Lesson& lesson) { return std::string(lesson.folder) + ".html"; }

std::string source_page_name(std::string_view path) {
  std::string name(path);
  std::ranges::replace(name, '/', '-');
  return "sources/" + name + ".html";
}

std::string lesson_html(const OpenLesson& lesson) { return Writer(lesson).blocks(lesson.document.blocks); }

}  // namespace hsr
