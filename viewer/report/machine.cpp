#include "report/machine.h"

#include <gmp.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <thread>

#include "lanes/instruction_sets.h"
#include "text_layout.h"

namespace hsr::report {
namespace {

/// What stands after the first line's "NAME :" in a file of such lines; empty if it is not there.
std::string value_in(const char* file, const std::string& name, char separator) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t end = line.find(separator);
    if (!line.starts_with(name) || end == std::string::npos) continue;
    const std::size_t begin = line.find_first_not_of(" \t\"", end + 1);
    if (begin == std::string::npos) return {};
    return line.substr(begin, line.find_last_not_of(" \t\"") - begin + 1);
  }
  return {};
}

std::string compiler() {
#if defined(__clang__)
  return "Clang " __clang_version__;
#elif defined(__GNUC__)
  return "GCC " __VERSION__;
#else
  return "unknown";
#endif
}

}  // namespace

std::vector<std::pair<std::string, std::string>> Machine::rows() const {
  return {{"processor", processor},
          {"cores", std::to_string(cores)},
          {"memory", significant(memory_gigabytes, 3) + " GB"},
          {"instruction set", instruction_set},
          {"system", system},
          {"compiler", compiler},
          {"build", build},
          {"hsr", version},
          {"libraries", libraries}};
}

Machine this_machine() {
  Machine machine;
  machine.processor = value_in("/proc/cpuinfo", "model name", ':');
  machine.cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  constexpr double gigabyte = 1e9;
  machine.memory_gigabytes =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE)) / gigabyte;
  machine.instruction_set = std::string(lanes::instruction_sets().front());
  utsname name{};
  if (uname(&name) == 0) machine.system = std::string(name.sysname) + " " + name.release + " " + name.machine;
  const std::string distribution = value_in("/etc/os-release", "PRETTY_NAME", '=');
  if (!distribution.empty()) machine.system = distribution + ", " + machine.system;
  machine.compiler = compiler();
  machine.build = HSR_BUILD_TYPE;
  machine.version = HSR_VERSION;
  machine.libraries = std::string("GMP ") + gmp_version;
  return machine;
}

}  // namespace hsr::report
