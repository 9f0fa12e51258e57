#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "picture.h"
#include "scene/progress.h"

namespace hsr::window {

/// Lets threads that draw go before this one and those that it starts.
void step_back();

/// How far a piece of work is, told by the thread that works and read by the one that draws.
class WorkProgress {
 public:
  /// For the worker. Returns false once stop() was called.
  Progress listener() {
    return [this](std::string_view stage, double done) {
      const std::lock_guard lock(mutex_);
      stage_ = stage;
      done_ = done;
      return !stop_;
    };
  }
  void stop() { stop_ = true; }
  bool stopped() const { return stop_; }
  std::pair<std::string, double> get() const {
    const std::lock_guard lock(mutex_);
    return {stage_, done_};
  }

 private:
  std::atomic<bool> stop_ = false;
  mutable std::mutex mutex_;
  std::string stage_;  // guarded by mutex_, as is done_
  double done_ = 0.0;
};

/// Whether a lane's thread lets those that draw go before it. What is short and waited for must not: some
/// schedulers leave a thread that steps back on the processor of the one that draws, although another is
/// free, and then it takes five times as long.
enum class Pace { steps_back, keeps_up };

/// One kind of long work, done in a thread of its own: at most one piece at a time, the newest that is
/// wanted next, and nothing that is done already. The last result stays until there is a new one.
///
/// All functions are for the one thread that draws.
template <class Key, class Result>
class Lane {
 public:
  using Work = std::function<Result(const Progress&)>;

  /// `wake` is called from the worker's thread when a piece is finished.
  explicit Lane(std::function<void()> wake, Pace pace = Pace::steps_back)
      : wake_(std::move(wake)), pace_(pace) {}
  Lane(const Lane&) = delete;
  Lane& operator=(const Lane&) = delete;
  ~Lane() {
    if (running_) running_->progress.stop();
    if (thread_.joinable()) thread_.join();
  }

  /// Says what the result should be of; called again and again, with the same key while nothing changes.
  /// `work` is only called if that is neither known nor on its way. With `impatient`, work on another
  /// key is stopped; otherwise it comes to its end first.
  void want(const Key& key, bool impatient, const std::function<Work()>& make_work) {
    if (!running_ && done_key_ == key) return;
    if (given_up_ == key) return;
    if (running_) {
      if (running_->key == key) return;
      if (impatient) running_->progress.stop();
      return;
    }
    start(key, make_work());
  }

  /// Takes over a finished piece. Returns whether the result is new.
  bool poll() {
    if (!running_ || !running_->finished) return false;
    thread_.join();
    const std::shared_ptr<Piece> piece = std::exchange(running_, nullptr);
    if (piece->progress.stopped()) return false;
    done_key_ = piece->key;
    error_ = piece->error;
    milliseconds_ = piece->milliseconds;
    if (!piece->result) return false;
    result_key_ = piece->key;
    old_ = std::exchange(result_, std::move(piece->result));
    return true;
  }

  /// Stops the running piece for good: it is not begun again until something else is wanted.
  void give_up() {
    if (!running_) return;
    running_->progress.stop();
    given_up_ = running_->key;
  }
  /// Stops the running piece for now: it is begun again when it is wanted again.
  void interrupt() {
    if (running_) running_->progress.stop();
  }
  /// Forgets that a piece was given up or failed.
  void retry() {
    given_up_.reset();
    if (!error_.empty()) done_key_.reset();
  }

  bool busy() const { return running_ != nullptr; }
  bool has_given_up() const { return given_up_.has_value() && !running_; }
  /// Of the running piece: the stage in words, and how much of it is done, 0 to 1.
  std::pair<std::string, double> progress() const {
    return running_ ? running_->progress.get() : std::pair<std::string, double>{};
  }
  double running_ms() const { return running_ ? running_->stopwatch.milliseconds() : 0.0; }
  /// The newest result and what it is of; null before there is one.
  std::shared_ptr<const Result> result() const { return result_; }
  const std::optional<Key>& result_key() const { return result_key_; }
  /// Why the piece that was last finished has no result; empty if it has one.
  const std::string& error() const { return error_; }
  /// How long the piece that was last finished took.
  double milliseconds() const { return milliseconds_; }

 private:
  struct Piece {
    Key key;
    WorkProgress progress;
    Stopwatch stopwatch;
    std::atomic<bool> finished = false;
    std::shared_ptr<const Result> result;
    std::string error;
    double milliseconds = 0.0;
  };

  void start(const Key& key, Work work) {
    given_up_.reset();
    auto piece = std::make_shared<Piece>();
    piece->key = key;
    running_ = piece;
    thread_ = std::thread(
        [piece, pace = pace_, old = std::move(old_), work = std::move(work), wake = wake_]() mutable {
          if (pace == Pace::steps_back) step_back();
          old = nullptr;  // gives back memory, which takes a while
          try {
            piece->result = std::make_shared<const Result>(work(piece->progress.listener()));
          } catch (const std::bad_alloc&) {
            piece->error = "out of memory";
          } catch (const std::exception& error) {
            piece->error = error.what();
          }
          work = nullptr;  // what it held is let go here, not when the next piece begins
          piece->milliseconds = piece->stopwatch.milliseconds();
          piece->finished = true;
          wake();
        });
  }

  std::function<void()> wake_;
  Pace pace_;
  std::thread thread_;
  std::shared_ptr<Piece> running_;
  std::optional<Key> done_key_;
  std::optional<Key> given_up_;
  std::optional<Key> result_key_;
  std::shared_ptr<const Result> result_;
  std::shared_ptr<const Result> old_;  // let go by the next piece's thread
  std::string error_;
  double milliseconds_ = 0.0;
};

}  // namespace hsr::window
