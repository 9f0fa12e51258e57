// The program hsr. Exit codes: 0 done; 1 the input or the machine failed; 2 wrong usage. A failure is
// one line on standard error.

#include <algorithm>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <variant>

#include "command_line.h"
#include "commands/commands.h"
#include "scene/errors.h"

namespace {

constexpr int input_failed = 1;
constexpr int wrong_usage = 2;

int report(std::string message, int exit_code) {
  // What the message quotes may hold line breaks or codes that move a terminal's cursor.
  std::ranges::replace_if(
      message, [](char letter) { return static_cast<unsigned char>(letter) < 32U || letter == '\x7f'; }, '?');
  std::cerr << "error: " << message << "\n";
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const hsr::Command command = hsr::parse_command_line(argc, argv);
    std::visit([](const auto& chosen) { hsr::run(chosen, std::cout); }, command);
    std::cout.flush();
    if (!std::cout) throw hsr::InputError("cannot write to standard output");
    return 0;
  } catch (const hsr::UsageError& error) {
    return report(error.what(), wrong_usage);
  } catch (const std::bad_alloc&) {
    return report("out of memory", input_failed);
  } catch (const std::exception& error) {
    return report(error.what(), input_failed);
  }
}
