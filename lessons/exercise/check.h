#pragma once

#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

extern "C" void __sanitizer_print_stack_trace() __attribute__((weak));

/// The side of an exercise's check that is compiled together with the student's function. Every case is put
/// to that function, to the right solution and to each known mistake, and what they gave is written as lines
/// of JSON, which the program hsr reads. Knows nothing of the rest of the kit, so that it compiles quickly.
namespace check {

/// What a function gave.
struct Answer {
  std::vector<double> numbers;  ///< what is compared
  std::string text;             ///< how it is told
  int width = 0;  ///< if not 0, the numbers are a picture of this width, row by row from the top
};

/// The shortest text of at most 9 digits.
inline std::string shown(double number) {
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", number);
  return text;
}

inline std::string in_brackets(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + shown(number);
  return "(" + text + ")";
}

/// An answer that is told as its numbers.
inline Answer answer(const std::vector<double>& numbers) {
  return {numbers, numbers.size() == 1 ? shown(numbers[0]) : in_brackets(numbers), 0};
}

inline Answer picture(int width, std::vector<double> numbers) { return {std::move(numbers), "", width}; }

/// Equal, or both no number, or within `tolerance`, relative to the greater.
inline bool same(double a, double b, double tolerance) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return true;
  return std::abs(a - b) <= tolerance * std::fmax(std::abs(a), std::abs(b));
}

/// Where there are no numbers, the texts are compared.
inline bool same(const Answer& a, const Answer& b, double tolerance) {
  if (a.numbers.size() != b.numbers.size()) return false;
  if (a.numbers.empty()) return a.text == b.text;
  for (std::size_t k = 0; k < a.numbers.size(); ++k) {
    if (!same(a.numbers[k], b.numbers[k], tolerance)) return false;
  }
  return true;
}

inline std::string quoted(const std::string& text) {
  std::string json = "\"";
  for (const char letter : text) {
    char code[8];
    if (letter == '"' || letter == '\\') {
      json += {'\\', letter};
    } else if (static_cast<unsigned char>(letter) < 32U) {
      std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(letter));
      json += code;
    } else {
      json += letter;
    }
  }
  return json + "\"";
}

/// JSON has no word for what is no number.
inline std::string as_json(const Answer& answer) {
  std::string json = "{\"text\":" + quoted(answer.text) + ",\"width\":" + std::to_string(answer.width);
  json += ",\"numbers\":[";
  for (std::size_t k = 0; k < answer.numbers.size(); ++k) {
    if (k > 0) json += ',';
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", answer.numbers[k]);
    json += std::isfinite(answer.numbers[k]) ? text : "null";
  }
  return json + "]}";
}

/// A function whose answers are known: the solution, which stands first, or a mistake.
template <class Function>
struct Known {
  const char* name;
  Function function;
};

/// Ends the program when a case takes too long, and says where it was.
[[noreturn]] inline void tell_stuck(int) {
  static const char text[] = "hsr: this case does not end; the program was here:\n";
  (void)!write(STDERR_FILENO, text, sizeof text - 1);
  if (__sanitizer_print_stack_trace != nullptr) __sanitizer_print_stack_trace();
  constexpr int stuck = 97;
  _exit(stuck);
}

inline void limit_seconds(int seconds) {
  signal(SIGPROF, tell_stuck);
  itimerval timer = {};
  timer.it_value.tv_sec = seconds;
  setitimer(ITIMER_PROF, &timer, nullptr);
}

template <class Function>
class Check {
 public:
  Check(std::FILE* results, Function student, const std::vector<Known<Function>>& known, std::string data)
      : data_file(std::move(data)), results_(results), student_(student), known_(known) {}

  double tolerance = 0.0;  ///< how far a number may be off, relative
  std::string view;        ///< lines of a viewer's state that shows the case
  std::string data_file;   ///< what the program hsr made for the checks, or empty
  int seconds = 3;         ///< of processor time for a case

  /// Where to write a picture's stream in place of results; null if results are wanted.
  std::FILE* picture() const { return picture_ ? results_ : nullptr; }
  /// The function whose picture is wanted.
  Function student() const { return student_; }
  void want_picture() { picture_ = true; }

  /// Calls `call(function)`, which gives an Answer, with every function. The solution's answer is wanted.
  template <class Call>
  void run(const std::string& name, const std::string& input, Call call) {
    run_case(name, input, call, nullptr);
  }
  /// The same where the answer is known otherwise, to which the solution is held too.
  template <class Call>
  void run(const std::string& name, const std::string& input, Call call, const Answer& want) {
    run_case(name, input, call, &want);
  }

 private:
  template <class Call>
  Answer guarded(Call call, Function function) {
    try {
      return call(function);
    } catch (const std::exception& error) {
      return {{}, std::string("an exception: ") + error.what(), 0};
    }
  }

  void write_line(const std::string& line) {
    std::fputs((line + "\n").c_str(), results_);
    std::fflush(results_);
  }

  template <class Call>
  void run_case(const std::string& name, const std::string& input, Call call, const Answer* told) {
    const std::string head =
        "\"name\":" + quoted(name) + ",\"input\":" + quoted(input) + ",\"view\":" + quoted(view);
    write_line("{\"begin\":true," + head + "}");
    limit_seconds(seconds);
    const Answer got = guarded(call, student_);
    limit_seconds(0);
    const Answer solved = guarded(call, known_[0].function);
    const Answer& want = told != nullptr ? *told : solved;
    std::string alike;
    for (std::size_t k = 1; k < known_.size(); ++k) {
      if (same(got, guarded(call, known_[k].function), tolerance))
        alike += (alike.empty() ? "" : ",") + quoted(known_[k].name);
    }
    write_line("{" + head + ",\"passed\":" + (same(got, want, tolerance) ? "true" : "false") +
               ",\"sound\":" + (same(solved, want, tolerance) ? "true" : "false") +
               ",\"got\":" + as_json(got) + ",\"want\":" + as_json(want) + ",\"alike\":[" + alike + "]}");
  }

  std::FILE* results_;
  bool picture_ = false;
  Function student_;
  const std::vector<Known<Function>>& known_;
};

/// The main function: PROGRAM RESULTS NAME [DATA]. NAME is "student" or that of a known function, which then
/// takes the student's place; or "picture": then the student's picture of the one scene in DATA is written.
template <class Function, class Checks>
int run_main(int argc, char** argv, Function student, const std::vector<Known<Function>>& known,
             Checks checks) {
  if (argc < 3) return 2;
  std::FILE* results = std::fopen(argv[1], "w");
  if (results == nullptr) return 2;
  Function tested = student;
  for (const Known<Function>& each : known) {
    if (std::string(argv[2]) == each.name) tested = each.function;
  }
  Check<Function> check(results, tested, known, argc > 3 ? argv[3] : "");
  if (std::string(argv[2]) == "picture") check.want_picture();
  checks(check);
  if (check.picture() == nullptr) std::fputs("{\"done\":true}\n", results);
  std::fclose(results);
  return 0;
}

}  // namespace check
