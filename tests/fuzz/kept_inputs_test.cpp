// The inputs that are kept beside the fuzzers: seeds, and whatever once broke a target.

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "fuzz/targets.h"
#include "support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;

/// Runs every target on the files kept for it; returns how many there were.
std::size_t run_kept_inputs(const fs::path& folder) {
  std::size_t count = 0;
  for (const hsr::fuzz::Target& target : hsr::fuzz::targets()) {
    const fs::path inputs = folder / target.name;
    if (!fs::is_directory(inputs)) continue;
    for (const fs::directory_entry& input : fs::directory_iterator(inputs)) {
      const std::string file = input.path().string();
      CAPTURE(file);
      CHECK_NOTHROW(target.run(hsr::test::content_of(input.path())));
      ++count;
    }
  }
  return count;
}

}  // namespace

TEST_CASE("fuzz: no input that once broke something breaks it again") {
  CHECK(run_kept_inputs(fs::path(HSR_FUZZ_INPUTS) / "regressions") > 0);
}

TEST_CASE("fuzz: every target keeps the kit's promises on its seeds") {
  CHECK(run_kept_inputs(fs::path(HSR_FUZZ_INPUTS) / "seeds") > 0);
}

TEST_CASE("fuzz: every target takes an empty input") {
  for (const hsr::fuzz::Target& target : hsr::fuzz::targets()) {
    CAPTURE(target.name);
    CHECK_NOTHROW(target.run(""));
  }
}
