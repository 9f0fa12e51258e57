#include "report/page.h"

#include <cstdint>
#include <utility>

#include "scene/atomic_file.h"
#include "text_file.h"

namespace hsr::report {
namespace {

constexpr const char* style = R"(
body { font: 17px/1.5 "DejaVu Sans", Verdana, sans-serif; color: #111; background: #fff; margin: 2em auto;
       max-width: 82em; padding: 0 1.5em; }
h1 { font-size: 1.7em; } h2 { font-size: 1.3em; margin-top: 2em; border-bottom: 1px solid #999; }
p { max-width: 50em; }
img { display: block; width: 100%; max-width: 1280px; height: auto; margin: 1em 0; }
.table { overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.85em; margin: 1em 0; }
th, td { padding: 0.15em 0.7em; text-align: left; white-space: nowrap; border-bottom: 1px solid #ddd; }
th { border-bottom: 2px solid #555; } .number { text-align: right; font-variant-numeric: tabular-nums; }
summary { cursor: pointer; margin: 1em 0; }
@media print { body { font-size: 10pt; margin: 0; max-width: none; } nav { display: none; }
  img, tr { break-inside: avoid; } h2 { break-after: avoid; } table { font-size: 7pt; } }
)";

/// As a page holds a file within itself.
std::string base64(const std::string& bytes) {
  constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(bytes.size() * 4 / 3 + 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t group = 0;
    for (std::size_t b = 0; b < 3; ++b)
      group = (group << 8U) | (k + b < bytes.size() ? static_cast<unsigned char>(bytes[k + b]) : 0U);
    for (std::size_t b = 0; b < 4; ++b)
      text += k + b <= bytes.size() ? letters[(group >> (18U - 6U * b)) & 63U] : '=';
  }
  return text;
}

}  // namespace

Page::Page(std::string title) : title_(std::move(title)) {}

void Page::chapter(const std::string& title) {
  const std::string anchor = "chapter-" + std::to_string(++chapters_);
  contents_ += "<li><a href=\"#" + anchor + "\">" + html_text(title) + "</a></li>\n";
  body_ += "<h2 id=\"" + anchor + "\">" + html_text(title) + "</h2>\n";
}

void Page::paragraph(const std::string& text) { body_ += "<p>" + html_text(text) + "</p>\n"; }

void Page::plot(const PlotFiles& files, const std::string& says) {
  if (files.svg.empty()) {
    paragraph("No picture was drawn, as gnuplot is not installed; its data are in " +
              files.data.filename().string() + ", its script in " + files.script.filename().string() + ".");
    return;
  }
  body_ += "<img alt=\"" + html_text(says) + "\" src=\"data:image/svg+xml;base64," +
           base64(read_text_file(files.svg)) + "\">\n";
}

void Page::table(const Table& table) { body_ += to_html(table); }

void Page::folded_table(const std::string& title, const Table& table) {
  body_ += "<details><summary>" + html_text(title) + "</summary>\n" + to_html(table) + "</details>\n";
}

std::string Page::html() const {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         html_text(title_) + "</title>\n<style>" + style + "</style>\n</head>\n<body>\n<h1>" +
         html_text(title_) + "</h1>\n<nav><ul>\n" + contents_ + "</ul></nav>\n" + body_ +
         "</body>\n</html>\n";
}

void Page::write(const std::filesystem::path& file) const {
  write_file_atomically(file,
                        [&](const std::filesystem::path& temporary) { write_bytes(temporary, html()); });
}

}  // namespace hsr::report
