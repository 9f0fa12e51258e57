#pragma once

#include <stdexcept>
#include <string>

namespace hsr {

/// The input or the machine failed: a file cannot be read, a mesh is broken, a disk is full.
/// The message is one line without "error: "; the program prints it and exits with 1.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The request itself is wrong: an unknown scene, algorithm, setting or skip, a value out of range.
/// The message names option, value and range; the program prints it and exits with 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace hsr
