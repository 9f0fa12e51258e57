#include "lesson/book.h"

#include <algorithm>

#include "lesson/html.h"
#include "lesson/lesson_html.h"
#include "output_file.h"
#include "scene/atomic_file.h"

namespace hsr {
namespace {

constexpr std::string_view book_title = "Hidden surfaces";

constexpr std::string_view style = R"(
:root { color-scheme: light dark; --text: #1a1d21; --faint: #59626d; --line: #c9d0d8; --field: #f1f3f6;
  --accent: #005a94; --page: #fff; }
@media (prefers-color-scheme: dark) { :root { --text: #e6e9ed; --faint: #a3acb8; --line: #3d4550;
  --field: #22272e; --accent: #6bbef0; --page: #16191e; } }
html { background: var(--page); color: var(--text); font: 17px/1.55 "DejaVu Serif", Georgia, serif; }
body { max-width: 46rem; margin: 0 auto; padding: 1rem 1.2rem 4rem; }
h1, h2, h3, nav, summary, table, figcaption { font-family: "DejaVu Sans", Verdana, sans-serif; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 1.5rem 0 1rem; }
h2 { font-size: 1.3rem; margin: 2.2rem 0 .6rem; border-bottom: 1px solid var(--line); padding-bottom: .2rem; }
h3 { font-size: 1.05rem; margin: 1.6rem 0 .4rem; }
p { margin: .7rem 0; } li { margin: .25rem 0; } li > p { margin: .3rem 0; }
a { color: var(--accent); overflow-wrap: anywhere; }
nav { display: flex; gap: 1rem; justify-content: space-between; font-size: .85rem; padding: .5rem 0; }
nav span { flex: 1; } nav span:nth-child(2) { text-align: center; } nav span:nth-child(3) { text-align: right; }
code { font: .86em/1.4 "DejaVu Sans Mono", Menlo, Consolas, monospace; background: var(--field);
  padding: .08em .25em; border-radius: .2em; overflow-wrap: anywhere; }
pre { background: var(--field); padding: .7rem .9rem; border-radius: .3rem; overflow-x: auto; }
pre code { padding: 0; background: none; overflow-wrap: normal; }
table { border-collapse: collapse; margin: 1rem 0; font-size: .85rem; display: block; overflow-x: auto; }
th, td { border: 1px solid var(--line); padding: .3rem .6rem; text-align: left; vertical-align: top; }
th { background: var(--field); }
figure { margin: 1.2rem 0; } figure img { width: 100%; height: auto; border: 1px solid var(--line); }
figcaption { font-size: .85rem; color: var(--faint); margin-top: .3rem; }
details { margin: .6rem 0; border-left: 3px solid var(--line); padding-left: .8rem; }
summary { cursor: pointer; font-size: .85rem; color: var(--accent); }
math[display="block"] { margin: 1rem 0; overflow-x: auto; overflow-y: hidden; padding: .2rem 0; }
.contents > li { margin: .8rem 0; } .contents ul { color: var(--faint); font-size: .9rem; }
.source td { border: 0; padding: 0 .8rem 0 0; white-space: pre; font: .8rem/1.45 "DejaVu Sans Mono", monospace; }
.source td:first-child { color: var(--faint); text-align: right; user-select: none; }
@media print {
  :root { --text: #000; --faint: #444; --line: #999; --field: #f4f4f4; --accent: #000; --page: #fff; }
  @page { margin: 20mm 18mm; }
  html { font-size: 11pt; } body { max-width: none; padding: 0; } nav { display: none; }
  .script { display: none; }
  h1, h2, h3 { break-after: avoid; } figure, table, pre, math { break-inside: avoid; }
  pre, pre code { white-space: pre-wrap; } a { text-decoration: none; } p { orphans: 3; widows: 3; }
}
)";

/// Answers are unfolded on paper, and folded again after it.
constexpr std::string_view unfold_for_print = R"(<script>
const answers = () => document.querySelectorAll("details.answer");
let folded = [];
addEventListener("beforeprint", () => { folded = [...answers()].filter(a => !a.open); folded.forEach(a => a.open = true); });
addEventListener("afterprint", () => folded.forEach(a => a.open = false));
</script>
)";

/// `to_top` leads from the page to the book's folder.
std::string page(std::string_view title, const std::string& body, std::string_view to_top = "") {
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  html += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  html += "<title>" + html_text(title) + "</title>\n";
  html += "<link rel=\"stylesheet\" href=\"" + std::string(to_top) + "book.css\">\n</head>\n<body>\n";
  return html + body + std::string(unfold_for_print) + "</body>\n</html>\n";
}

std::string link(const std::string& address, const std::string& text) {
  return "<a href=\"" + html_text(address) + "\">" + html_text(text) + "</a>";
}

std::string numbered_title(const OpenLesson& lesson) {
  return std::to_string(lesson.number) + ". " + std::string(lesson.lesson->title);
}

std::string way(const OpenLesson* before, const OpenLesson* after) {
  std::string html = "<nav><span>";
  if (before != nullptr) html += "\u2190 " + link(page_name(*before->lesson), numbered_title(*before));
  html += "</span><span>" + link("index.html", "Contents") + "</span><span>";
  if (after != nullptr) html += link(page_name(*after->lesson), numbered_title(*after)) + " \u2192";
  return html + "</span></nav>\n";
}

/// A lesson in the contents: its title, and below it what is shown live.
std::string contents_of(const OpenLesson& lesson) {
  std::string html = "<li>" + link(page_name(*lesson.lesson), std::string(lesson.lesson->title)) + "\n<ul>\n";
  int heading = 0;
  bool below_demonstration = false;
  for (const Block& block : lesson.document.blocks) {
    if (block.kind != Block::Kind::heading) continue;
    const std::string text = plain_text(block.words);
    if (block.level == 2) below_demonstration = text == "Live demonstration";
    if (block.level == 3 && below_demonstration)
      html += "<li>" + link(page_name(*lesson.lesson) + "#h" + std::to_string(heading), text) + "</li>\n";
    ++heading;
  }
  return html + "</ul></li>\n";
}

std::string index(std::span<const OpenLesson> lessons) {
  std::string body = "<h1>" + std::string(book_title) + "</h1>\n";
  body +=
      "<p>A course on the visibility problem: which surface does one see at each pixel? Every figure was "
      "made, and "
      "every number that the text quotes is checked, by the hidden-surface kit. Each lesson can be run live: "
      "<code>hsr lesson run 1</code>.</p>\n<h2>Contents</h2>\n<ol class=\"contents\">\n";
  for (const OpenLesson& lesson : lessons) body += contents_of(lesson);
  return page(book_title, body + "</ol>\n");
}

bool is_lesson(const CarriedFile& file) { return file.path.starts_with("lessons/"); }

std::string source_page(const CarriedFile& file) {
  std::string body = "<nav><span>" + link("../index.html", "Contents") + "</span></nav>\n<h1>" +
                     html_text(file.path) + "</h1>\n<table class=\"source\">\n";
  int number = 1;
  for (std::size_t begin = 0; begin < file.text.size(); ++number) {
    const std::size_t end = std::min(file.text.find('\n', begin), file.text.size());
    body += "<tr><td>" + std::to_string(number) + "</td><td>" +
            html_text(file.text.substr(begin, end - begin)) + "</td></tr>\n";
    begin = end + 1;
  }
  return page(file.path, body + "</table>\n", "../");
}

void write_page(const std::filesystem::path& file, const std::string& text) {
  write_file_atomically(file, [&](const std::filesystem::path& temporary) { write_bytes(temporary, text); });
}

}  // namespace

void write_book(std::span<const OpenLesson> lessons, const std::filesystem::path& folder) {
  make_folder(folder / "sources");
  for (std::size_t k = 0; k < lessons.size(); ++k) {
    const std::string links =
        way(k > 0 ? &lessons[k - 1] : nullptr, k + 1 < lessons.size() ? &lessons[k + 1] : nullptr);
    write_page(folder / page_name(*lessons[k].lesson),
               page(numbered_title(lessons[k]), links + lesson_html(lessons[k]) + links));
  }
  for (const CarriedFile& file : carried_files()) {
    if (!is_lesson(file)) write_page(folder / source_page_name(file.path), source_page(file));
  }
  write_page(folder / "book.css", std::string(style));
  write_page(folder / "index.html", index(lessons));
}

}  // namespace hsr
