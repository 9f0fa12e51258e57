#pragma once

#include <filesystem>
#include <string>

#include "report/plot.h"
#include "report/table.h"

namespace hsr::report {

/// A page of text, plots and tables in one HTML file that needs no other file and no network.
class Page {
 public:
  explicit Page(std::string title);

  /// A chapter; all chapters are listed at the top of the page.
  void chapter(const std::string& title);
  /// Plain text.
  void paragraph(const std::string& text);
  /// The picture of a plot, or, where none was drawn, a line that names its data. `says` is for those who
  /// cannot see it.
  void plot(const PlotFiles& files, const std::string& says);
  void table(const Table& table);
  /// A long table behind a line to click on.
  void folded_table(const std::string& title, const Table& table);

  std::string html() const;
  /// Throws InputError.
  void write(const std::filesystem::path& file) const;

 private:
  std::string title_;
  std::string contents_;
  std::string body_;
  int chapters_ = 0;
};

}  // namespace hsr::report
