#include "exercise/check.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "child_process.h"
#include "exercise/accident.h"
#include "scene/errors.h"
#include "text_file.h"

namespace hsr {
namespace {

using Json = nlohmann::json;
using std::filesystem::path;

constexpr std::string_view starter_sentence =
    "These are still the answers of the starter. Read task.md and write the function.";

/// What is left of a long output: its beginning, as that says what happened first.
std::string beginning_of(const path& file) {
  constexpr std::size_t most = 20000;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return {};
  constexpr std::size_t far_too_much = 200'000'000;
  std::string text = read_text_file(file, far_too_much);
  if (text.size() > most) text.resize(most);
  return text;
}

CaseAnswer answer_from(const Json& json) {
  CaseAnswer answer;
  answer.text = json.at("text");
  answer.width = json.at("width");
  for (const Json& number : json.at("numbers"))
    answer.numbers.push_back(number.is_null() ? std::nan("") : number.get<double>());
  return answer;
}

/// What the lines of a result file tell.
struct Results {
  std::vector<CaseResult> cases;
  std::optional<CaseResult> begun;  // and not finished
  bool done = false;
};

Results read_results(const path& file) {
  Results results;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return results;
  constexpr std::size_t most = 200'000'000;
  std::istringstream lines(read_text_file(file, most));
  for (std::string line; std::getline(lines, line);) {
    const Json json = Json::parse(line, nullptr, false);
    if (json.is_discarded()) break;  // the line that it was just writing
    if (json.contains("done")) {
      results.done = true;
      break;
    }
    CaseResult result;
    result.name = json.at("name");
    result.input = json.at("input");
    result.view = json.at("view");
    if (json.contains("begin")) {
      results.begun = result;
      continue;
    }
    result.passed = json.at("passed");
    result.sound = json.at("sound");
    result.got = answer_from(json.at("got"));
    result.want = answer_from(json.at("want"));
    result.alike = json.at("alike").get<std::vector<std::string>>();
    results.cases.push_back(std::move(result));
    results.begun.reset();
  }
  return results;
}

/// How well a known function explains what failed.
struct Explanation {
  std::string name;
  std::size_t explained = 0;  ///< failed cases where it gives the same
  std::size_t against = 0;    ///< cases where it gives something else
};

bool is_alike(const CaseResult& result, const std::string& name) {
  return std::ranges::find(result.alike, name) != result.alike.end();
}

Explanation best_explanation(const std::vector<std::string>& names, const std::vector<CaseResult>& cases,
                             const std::vector<const CaseResult*>& failed) {
  Explanation best;
  for (const std::string& name : names) {
    Explanation each = {name, 0, 0};
    for (const CaseResult* result : failed) each.explained += is_alike(*result, name) ? 1U : 0U;
    for (const CaseResult& result : cases) each.against += is_alike(result, name) ? 0U : 1U;
    if (each.explained > best.explained ||
        (each.explained == best.explained && each.explained > 0 && each.against < best.against))
      best = each;
  }
  return best;
}

/// The mistakes that together explain the failed cases: the one that explains most, then the one that
/// explains most of what is left. None if less than half is explained: a guess would mislead.
std::vector<std::string> explain(const Exercise& exercise, const std::vector<CaseResult>& cases) {
  std::vector<const CaseResult*> failed;
  for (const CaseResult& result : cases) {
    if (!result.passed) failed.push_back(&result);
  }
  std::vector<std::string> names;
  for (const Mistake& mistake : exercise.mistakes) names.push_back(mistake.name);
  names.emplace_back("starter");
  const std::size_t all = failed.size();
  std::vector<std::string> chosen;
  constexpr std::size_t most = 2;
  while (!failed.empty() && chosen.size() < most) {
    const Explanation best = best_explanation(names, cases, failed);
    if (best.explained == 0) break;
    chosen.push_back(best.name);
    std::erase_if(failed, [&](const CaseResult* result) { return is_alike(*result, best.name); });
  }
  if (2 * failed.size() > all) chosen.clear();
  return chosen;
}

std::string sentence_of(const Exercise& exercise, const std::string& name) {
  for (const Mistake& mistake : exercise.mistakes) {
    if (mistake.name == name) return mistake.sentence;
  }
  return std::string(starter_sentence);
}

std::vector<std::string> names_of(const std::vector<CaseResult>& cases) {
  std::vector<std::string> names;
  for (const CaseResult& result : cases) names.push_back(result.name);
  return names;
}

}  // namespace

std::size_t ExerciseCheck::passed_count() const {
  return static_cast<std::size_t>(std::ranges::count_if(cases, &CaseResult::passed));
}

bool ExerciseCheck::passed() const {
  return build.done && accident.what.empty() && !cases.empty() && passed_count() == cases.size();
}

ProgramEnd run_built(const ExerciseBuild& build, const std::string& name, const CheckLimits& limits,
                     const path& data) {
  constexpr std::uint64_t megabyte = 1'000'000;
  const std::string most = std::to_string(limits.megabytes);
  // A sanitized program takes address space without end, so its own limit on what it uses is taken.
  const ChildLimits child = {
      .seconds = limits.seconds,
      .memory = build.sanitized ? ~std::uint64_t{0} : megabyte * static_cast<std::uint64_t>(limits.megabytes),
      .output = 1'000'000};
  const path folder = build.program.parent_path();
  ProgramEnd end;
  end.results = folder / "results";
  std::error_code ignored;
  std::filesystem::remove(end.results, ignored);
  const std::string command = "cd " + shell_word(folder.string()) + " && exec ./program results " +
                              shell_word(name) + " " + (data.empty() ? "" : shell_word(data.string())) +
                              " 2> errors.txt";
  const ChildRun run =
      run_command(command,
                  {{"ASAN_OPTIONS", "detect_leaks=0:handle_abort=1:hard_rss_limit_mb=" + most},
                   {"UBSAN_OPTIONS", "print_stacktrace=1"}},
                  child);
  end.ended = run.ended;
  end.printed = run.out;
  end.seconds = run.seconds;
  end.said = beginning_of(folder / "errors.txt");
  return end;
}

ExerciseCheck run_check(const Exercise& exercise, const ExerciseBuild& build, const std::string& name,
                        const CheckLimits& limits, const path& data) {
  const ProgramEnd end = run_built(build, name, limits, data);
  const Results results = read_results(end.results);
  ExerciseCheck check;
  check.build = build;
  check.cases = results.cases;
  check.all = names_of(results.cases);
  check.printed = end.printed;
  check.seconds = end.seconds;
  if (!results.done) {
    check.accident = accident_of(exercise, end.ended, end.said);
    if (results.begun) {
      check.accident.name = results.begun->name;
      check.accident.input = results.begun->input;
      check.accident.view = results.begun->view;
    }
    // The solution goes through all cases, so it knows how many there are.
    check.all = names_of(read_results(run_built(build, "solution", limits, data).results).cases);
  } else {
    check.printed += end.said;
  }
  check.mistakes = explain(exercise, check.cases);
  for (const std::string& mistake : check.mistakes) check.sentences.push_back(sentence_of(exercise, mistake));
  return check;
}

}  // namespace hsr
