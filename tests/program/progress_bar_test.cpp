#include "progress_bar.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>
#include <vector>

using namespace std::chrono_literals;

namespace {

struct Closer {
  void operator()(std::FILE* stream) const { (void)std::fclose(stream); }
};
using Stream = std::unique_ptr<std::FILE, Closer>;

std::string content(std::FILE* stream) {
  std::string text;
  std::rewind(stream);
  for (int letter = std::fgetc(stream); letter != EOF; letter = std::fgetc(stream)) {
    text += static_cast<char>(letter);
  }
  return text;
}

}  // namespace

TEST_CASE("program: the bar grows with the work") {
  CHECK(hsr::progress_bar_text("rendering", 0.0, 80) ==
        "rendering                    [" + std::string(40, ' ') + "]   0 %");
  CHECK(hsr::progress_bar_text("rendering", 0.5, 80) ==
        "rendering                    [" + std::string(20, '#') + std::string(20, ' ') + "]  50 %");
  CHECK(hsr::progress_bar_text("rendering", 1.0, 80) ==
        "rendering                    [" + std::string(40, '#') + "] 100 %");
  CHECK(hsr::progress_bar_text("rendering", 2.0, 80).ends_with("100 %"));
  CHECK(hsr::progress_bar_text("rendering", -1.0, 80).ends_with("  0 %"));
}

TEST_CASE("program: the bar keeps to the width of the terminal") {
  const std::string stage = "zbuffer[depth=unorm16,snap=4,transparency=blend]: rendering";
  for (const std::size_t width : {20U, 21U, 40U, 79U, 120U, 200U}) {
    CHECK(hsr::progress_bar_text(stage, 0.3, width).size() <= width);
    CHECK(hsr::progress_bar_text("reading", 0.3, width).size() <= width);
  }
  CHECK(hsr::progress_bar_text(stage, 0.3, 120).starts_with(stage));
}

TEST_CASE("program: progress is shown only after a while") {
  const Stream stream(std::tmpfile());
  {
    hsr::ProgressBar bar(stream.get(), 1h);
    const hsr::Progress progress = bar.listener();
    for (int k = 0; k < 1000; ++k) CHECK(progress("rendering", k / 1000.0));
  }
  CHECK(content(stream.get()).empty());
}

TEST_CASE("program: elsewhere than on a terminal progress is plain lines, not more than one a second") {
  const Stream stream(std::tmpfile());
  {
    hsr::ProgressBar bar(stream.get(), 0ms);
    const hsr::Progress progress = bar.listener("zbuffer");
    std::vector<std::thread> threads;
    for (int thread = 0; thread < 4; ++thread) {
      threads.emplace_back([&] {
        for (int k = 0; k < 1000; ++k) (void)progress("rendering", 0.421);
      });
    }
    for (std::thread& thread : threads) thread.join();
  }
  const std::string text = content(stream.get());
  // One line, or very few if a machine takes seconds for this.
  CHECK(text.starts_with("zbuffer: rendering: 42 %\n"));
  CHECK(std::ranges::count(text, '\n') <= 3);
  CHECK(text.find('\r') == std::string::npos);
}
