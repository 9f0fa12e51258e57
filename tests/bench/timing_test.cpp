#include "bench/timing.h"

#include <doctest/doctest.h>

#include <string>

namespace hsr::bench {
namespace {

/// Writes its letter into a common record each time it runs, and takes as long as it is told.
class Recorded : public Contestant {
 public:
  Recorded(char letter, double ms, std::string& record) : letter_(letter), ms_(ms), record_(record) {}
  double run() override {
    record_ += letter_;
    return ms_;
  }
  Frame picture() override { return {}; }
  double prepare_ms() const override { return 0.0; }

 private:
  char letter_;
  double ms_;
  std::string& record_;
};

}  // namespace

TEST_CASE(
    "bench: a race runs all in turn, each round beginning with another one, after one run that does not "
    "count") {
  std::string record;
  Recorded a('a', 1.0, record);
  Recorded b('b', 2.0, record);
  Recorded c('c', 4.0, record);
  const RaceLimits limits = {.least_rounds = 3, .most_rounds = 3, .seconds = 1e9, .settled = 0.0};
  const std::vector<Timing> timings = race({&a, &b, &c}, limits, [] { return true; });
  CHECK(record == "abcabcbcacab");
  REQUIRE(timings.size() == 3);
  CHECK(timings[1].ms == std::vector<double>{2.0, 2.0, 2.0});
}

TEST_CASE("bench: a race ends when the ratios are settled, and not before its least rounds") {
  std::string record;
  Recorded a('a', 1.0, record);
  Recorded b('b', 2.0, record);
  const RaceLimits limits = {.least_rounds = 4, .most_rounds = 100, .seconds = 1e9, .settled = 0.02};
  CHECK(race({&a, &b}, limits, [] { return true; })[0].ms.size() == 4);
}

TEST_CASE("bench: a race that is stopped keeps the rounds that are whole") {
  std::string record;
  Recorded a('a', 1.0, record);
  Recorded b('b', 2.0, record);
  const RaceLimits limits = {.least_rounds = 9, .most_rounds = 9, .seconds = 1e9, .settled = 0.0};
  const std::vector<Timing> timings = race({&a, &b}, limits, [&record] { return record.size() < 7; });
  CHECK(timings[0].ms.size() == 2);
  CHECK(timings[1].ms.size() == 2);
}

TEST_CASE("bench: a ratio is that of the rounds, not of the means") {
  // Both were twice as slow in the second and third round, which says nothing about either.
  const Timing slow = {{10.0, 20.0, 20.0, 11.0}};
  const Timing fast = {{1.0, 2.0, 2.0, 1.0}};
  CHECK(ratio(slow, fast).median == doctest::Approx(10.0));
  CHECK(ratio(slow, fast).low == doctest::Approx(10.0));
  CHECK(ratio(slow, fast).high == doctest::Approx(10.25));
  CHECK(slow.least() == 10.0);
  CHECK(slow.median() == doctest::Approx(15.5));
}

TEST_CASE("bench: who has run often enough drops out, and the others go on in turn") {
  std::string record;
  Recorded steady('a', 1.0, record);
  Recorded slow('b', 2000.0, record);
  Recorded again('c', 400.0, record);
  const RepeatLimits limits = {.least = 4, .most = 9, .seconds = 1.0, .settled = 0.05};
  const std::vector<Repeats> repeats = repeat_in_turn({&steady, &slow, &again}, limits, [] { return true; });
  // Its first run took longer than all of its time, so that one counts; the third has time for three.
  CHECK(record == "abcaccacaa");
  CHECK(repeats[0].timing.ms.size() == 4);
  CHECK(repeats[0].settled);
  CHECK(repeats[1].timing.ms == std::vector<double>{2000.0});
  CHECK_FALSE(repeats[1].settled);
  CHECK(repeats[2].timing.ms.size() == 3);
  CHECK_FALSE(repeats[2].settled);
}

}  // namespace hsr::bench
