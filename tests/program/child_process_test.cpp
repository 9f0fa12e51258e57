#include "child_process.h"

#include <doctest/doctest.h>

#include "support/effort.h"

namespace hsr::test {
namespace {

ChildRun run(const std::string& command, const ChildLimits& limits = {}) {
  return run_command(command, {{"HSR_TEST_WORD", "a b"}}, limits);
}

}  // namespace

TEST_CASE("program: a command's outputs are taken, and its environment is what was given") {
  const ChildRun done = run("printf '%s' \"$HSR_TEST_WORD\"; echo remark >&2");
  CHECK(done.ended.empty());
  CHECK(done.out == "a b");
  CHECK(done.err == "remark\n");
}

TEST_CASE("program: much output on both streams at once comes through") {
  const ChildRun done = run("head -c 3000000 /dev/zero; head -c 300000 /dev/zero >&2");
  CHECK(done.ended.empty());
  CHECK(done.out.size() == 3'000'000);
  CHECK(done.err.size() <= 4000);  // its end only
}

TEST_CASE("program: how a command failed is told") {
  CHECK(run("exit 3").ended == "it ended with exit code 3");
  CHECK(run("kill -SEGV $$").ended.starts_with("it crashed (Segmentation fault"));
  CHECK(run("sh -c 'kill -ABRT $$'; exit $?").ended.starts_with("it crashed (Aborted"));
  CHECK(run("no-such-program-at-all").ended == "it ended with exit code 127");
}

TEST_CASE("program: a command that does not end, or writes too much, is ended with all that it started") {
  const ChildRun endless = run("sleep 100 & while true; do :; done", {.seconds = 0.2});
  CHECK(endless.ended == "it took longer than 0.200 s and was ended");
  CHECK(endless.seconds < 5.0);
  // One that closes its outputs and goes on, and one whose child keeps them open.
  CHECK(run("exec >&- 2>&-; sleep 100", {.seconds = 0.2}).ended.find("took longer") != std::string::npos);
  CHECK(run("sleep 100 & exit 0", {.seconds = 0.2}).ended.find("took longer") != std::string::npos);
  CHECK(run("cat /dev/zero", {.output = 1'000'000}).ended ==
        "it wrote more than a picture needs and was ended");
}

TEST_CASE("program: a command can be stopped") {
  const auto stop = [](std::string_view, double) { return false; };
  CHECK(run_command("sleep 100", {}, {}, stop).ended == "it was stopped");
}

TEST_CASE("program: a command that wants more memory than it may have gets none") {
  if (sanitized) return;  // whose programs need address space without end
  const ChildRun done =
      run("head -c 400000000 /dev/zero | tail -c 300000000 | wc -c", {.memory = 100'000'000});
  CHECK(done.out.find("300000000") == std::string::npos);
}

}  // namespace hsr::test
