#include <algorithm>
#include <nlohmann/json.hpp>

#include "exercise/report.h"
#include "text_layout.h"

namespace hsr {
namespace {

/// Text within XML; control characters, which XML 1.0 cannot hold, become question marks.
std::string xml(const std::string& text) {
  std::string escaped;
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    switch (letter) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += code < 32U && letter != '\n' && letter != '\t' ? '?' : letter;
    }
  }
  return escaped;
}

/// How many cases there are; one where it does not even compile.
std::size_t case_count(const ExerciseCheck& check) {
  return std::max<std::size_t>({check.all.size(), check.cases.size(), 1});
}

/// From 0, no better than the starter, to 1.
double share_of(const CheckedExercise& checked) {
  if (checked.check.passed()) return 1.0;
  const auto free = static_cast<double>(checked.starter_passed);
  const auto passed = static_cast<double>(checked.check.passed_count());
  const auto cases = static_cast<double>(case_count(checked.check));
  return cases > free ? std::max(0.0, passed - free) / (cases - free) : 0.0;
}

std::string seconds_text(double seconds) { return significant(seconds, 3); }

std::string junit_case(const CheckedExercise& checked, const std::string& name, const std::string& failure) {
  const std::string head =
      "    <testcase classname=\"" + xml(checked.exercise->name) + "\" name=\"" + xml(name) + "\"";
  if (failure.empty()) return head + "/>\n";
  return head + ">\n      <failure message=\"" + xml(failure) + "\">" + xml(checked.report) +
         "</failure>\n    </testcase>\n";
}

/// Why the case failed; empty if it passed.
std::string failure_of(const ExerciseCheck& check, const std::string& name) {
  for (const CaseResult& result : check.cases) {
    if (result.name != name) continue;
    if (result.passed) return {};
    return result.want.width > 0 ? "the picture differs"
                                 : "got " + result.got.text + ", want " + result.want.text;
  }
  return check.accident.name == name ? check.accident.what : "not reached";
}

std::string junit_suite(const CheckedExercise& checked) {
  const ExerciseCheck& check = checked.check;
  std::string cases;
  std::size_t failures = 0;
  if (check.all.empty()) {
    cases =
        junit_case(checked, "builds and runs", check.build.done ? check.accident.what : "does not compile");
    failures = 1;
  }
  for (const std::string& name : check.all) {
    const std::string failure = failure_of(check, name);
    failures += failure.empty() ? 0U : 1U;
    cases += junit_case(checked, name, failure);
  }
  return "  <testsuite name=\"" + xml(checked.exercise->name) + "\" tests=\"" +
         std::to_string(case_count(check)) + "\" failures=\"" + std::to_string(failures) + "\" time=\"" +
         seconds_text(check.build.seconds + check.seconds) + "\">\n" + cases + "  </testsuite>\n";
}

}  // namespace

std::string junit_text(const std::vector<CheckedExercise>& checked) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
  for (const CheckedExercise& each : checked) text += junit_suite(each);
  return text + "</testsuites>\n";
}

std::string gradescope_text(const std::vector<CheckedExercise>& checked) {
  constexpr double points = 10.0;  // of each exercise
  nlohmann::ordered_json tests = nlohmann::ordered_json::array();
  for (const CheckedExercise& each : checked) {
    const double share = share_of(each);
    tests.push_back({{"name", each.exercise->name + ": " + each.exercise->title},
                     {"score", points * share},
                     {"max_score", points},
                     {"status", each.check.passed() ? "passed" : "failed"},
                     {"output", each.report},
                     {"visibility", "visible"}});
  }
  return nlohmann::ordered_json({{"tests", tests}})
             .dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
         "\n";
}

}  // namespace hsr
