#include "progress_bar.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "text_layout.h"

namespace hsr {
namespace {

constexpr std::chrono::milliseconds redraw_every{100};
constexpr std::chrono::milliseconds print_every{1000};
constexpr const char* erase_line = "\r\033[K";

/// How many characters fit on a line of the terminal.
std::size_t terminal_width(std::FILE* stream) {
  winsize size{};
  return ioctl(fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

double within_unit(double done) { return done > 0.0 ? std::min(done, 1.0) : 0.0; }

std::string percent(double done) {
  return std::to_string(static_cast<int>(std::floor(100.0 * within_unit(done)))) + " %";
}

}  // namespace

std::string progress_bar_text(std::string_view stage, double done, std::size_t width) {
  constexpr std::size_t around = 10;  // spaces, brackets and per cent
  constexpr std::size_t fewest_cells = 10;
  constexpr std::size_t most_cells = 40;
  const std::size_t room = std::max(width, around + fewest_cells) - around;
  const std::size_t label_wanted = std::max(text_width(stage), std::size_t{28});
  const std::size_t cells = std::clamp(room - std::min(room, label_wanted), fewest_cells, most_cells);
  const std::size_t label = std::min(room - cells, label_wanted);

  const auto full = static_cast<std::size_t>(static_cast<double>(cells) * within_unit(done));
  return pad_right(stage.substr(0, label), label) + " [" + std::string(full, '#') +
         std::string(cells - full, ' ') + "] " + pad_left(percent(done), 5);
}

ProgressBar::ProgressBar(std::FILE* stream, std::chrono::milliseconds patience)
    : stream_(stream), on_terminal_(isatty(fileno(stream)) == 1), next_(Clock::now() + patience) {}

ProgressBar::~ProgressBar() { erase(); }

Progress ProgressBar::listener(std::string title) {
  return [this, title = std::move(title)](std::string_view stage, double done) {
    if (Clock::now() >= next_.load(std::memory_order_relaxed)) show(title, stage, done);
    return true;
  };
}

void ProgressBar::show(std::string_view title, std::string_view stage, double done) {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock) return;  // another thread is showing something at this moment
  const Clock::time_point now = Clock::now();
  if (now < next_.load()) return;
  next_ = now + (on_terminal_ ? redraw_every : print_every);
  const std::string what =
      title.empty() ? std::string(stage) : std::string(title) + ": " + std::string(stage);
  const std::string text = on_terminal_
                               ? erase_line + progress_bar_text(what, done, terminal_width(stream_) - 1)
                               : what + ": " + percent(done) + "\n";
  (void)std::fputs(text.c_str(), stream_);
  (void)std::fflush(stream_);
  visible_ = on_terminal_;
}

void ProgressBar::erase() {
  const std::scoped_lock lock(mutex_);
  if (!visible_) return;
  (void)std::fputs(erase_line, stream_);
  (void)std::fflush(stream_);
  visible_ = false;
}

}  // namespace hsr
