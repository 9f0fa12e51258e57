#include "window/file_watch.h"

#include <chrono>
#include <utility>

namespace hsr::window {

FileWatch::FileWatch(std::filesystem::path file, std::function<void()> saved)
    : thread_([file = std::move(file), saved = std::move(saved)](const std::stop_token& stop) {
        constexpr std::chrono::milliseconds pause(100);
        std::error_code error;
        auto seen = std::filesystem::last_write_time(file, error);
        while (!stop.stop_requested()) {
          std::this_thread::sleep_for(pause);
          const auto written = std::filesystem::last_write_time(file, error);
          if (error || written == seen) continue;
          seen = written;
          saved();
        }
      }) {}

}  // namespace hsr::window
