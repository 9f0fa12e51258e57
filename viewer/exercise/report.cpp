#include "exercise/report.h"

#include <algorithm>

#include "text_layout.h"

namespace hsr {
namespace {

/// A text of one or more lines below a label.
std::string labelled(const std::string& label, const std::string& text) {
  constexpr std::size_t indent = 4;
  constexpr std::size_t column = 12;
  return definition(label, text, indent, column);
}

std::string case_text(const CaseResult& result) {
  std::string text = "  ✗ " + result.name + "\n";
  if (!result.input.empty()) text += labelled("input", result.input);
  if (result.want.width > 0 && result.got.width > 0) return text + picture_text(result.got, result.want);
  return text + labelled("got", result.got.text) + labelled("want", result.want.text);
}

std::string accident_text(const Exercise& exercise, const Accident& accident) {
  std::string text = "  ✗ " + (accident.name.empty() ? "before the first case" : accident.name) + "\n";
  if (!accident.input.empty()) text += labelled("input", accident.input);
  text += labelled(
      "ended", "Your program " +
                   (accident.what.starts_with("it ") ? accident.what.substr(3) : "ended: " + accident.what) +
                   ".");
  text += labelled(
      "where", accident.place.empty() ? "no line of " + exercise.file_name() + " is known" : accident.place);
  if (!accident.detail.empty()) text += labelled("it said", accident.detail);
  return text;
}

/// Without line breaks at the end.
std::string without_end(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

/// The failed cases: the first in full, of the others the names.
std::string failures_text(const ExerciseCheck& check) {
  constexpr int most_names = 4;
  std::string text;
  std::string names;
  int more = 0;
  for (const CaseResult& result : check.cases) {
    if (result.passed) continue;
    if (text.empty()) {
      text = case_text(result);
    } else if (++more <= most_names) {
      names += (names.empty() ? "" : "; ") + result.name;
    }
  }
  if (more > most_names) names += "; and " + std::to_string(more - most_names) + " more";
  if (!names.empty()) text += labelled("also", names);
  return text;
}

}  // namespace

std::string report_text(const Exercise& exercise, const ExerciseCheck& check,
                        const std::vector<std::string>& look) {
  std::string text = exercise.name + ": " + exercise.title + "\n";
  if (!check.build.done) {
    text += "\n" + check.build.messages + "\n  ✗ It does not compile.\n";
    if (!check.build.advice.empty()) text += paragraph(check.build.advice);
    return text;
  }
  if (!check.build.messages.empty()) text += "\n" + check.build.messages + "\n";
  if (!check.build.sanitized)
    text += paragraph("This compiler has no sanitizers: wrong memory accesses may go unnoticed.");
  const std::size_t cases = std::max(check.all.size(), check.cases.size());
  text += check.passed() ? "  ✓ all " + std::to_string(cases) + " cases pass\n"
                         : "  " + std::to_string(check.passed_count()) + " of " + std::to_string(cases) +
                               " cases pass\n";
  if (!check.accident.what.empty()) text += "\n" + accident_text(exercise, check.accident);
  const std::string failures = failures_text(check);
  if (!failures.empty()) text += "\n" + failures;
  for (const std::string& sentence : check.sentences) text += "\n" + paragraph("Probably: " + sentence);
  if (!check.printed.empty())
    text += "\nYour program wrote:\n" + without_end(check.printed.substr(0, 2000)) + "\n";
  if (!look.empty()) text += "\n";
  for (const std::string& line : look) text += line + "\n";
  return text;
}

}  // namespace hsr
