#pragma once

#include <string>
#include <utility>
#include <vector>

namespace hsr::report {

/// What figures depend on beside the program's text.
struct Machine {
  std::string processor;        ///< as the system calls it
  int cores = 1;                ///< that threads can run on at once
  double memory_gigabytes = 0;  ///< of 10^9 bytes
  std::string instruction_set;  ///< the best that the fast versions can use
  std::string system;           ///< its name and version
  std::string compiler;
  std::string build;      ///< how it was compiled: "Release"
  std::string version;    ///< of hsr
  std::string libraries;  ///< those that matter to figures, with versions

  /// Each by its name, for tables and files.
  std::vector<std::pair<std::string, std::string>> rows() const;
};

/// This machine, and how this program was built.
Machine this_machine();

}  // namespace hsr::report
