#include "child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include "scene/errors.h"
#include "text_layout.h"

extern char** environ;

namespace hsr {
namespace {

using Clock = std::chrono::steady_clock;

/// A pipe whose ends are not handed on to other processes.
class Pipe {
 public:
  Pipe() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0)
      throw InputError(std::string("no pipe: ") + std::strerror(errno));
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  int read_end() const { return ends_[0]; }
  int write_end() const { return ends_[1]; }
  void close_end(std::size_t end) {
    if (ends_[end] >= 0) close(ends_[end]);
    ends_[end] = -1;
  }

 private:
  std::array<int, 2> ends_ = {-1, -1};
};

/// The environment of this process and the variables, as exec takes it.
class Environment {
 public:
  explicit Environment(const std::vector<std::pair<std::string, std::string>>& variables) {
    for (char** entry = environ; *entry != nullptr; ++entry) texts_.emplace_back(*entry);
    for (const auto& [name, value] : variables) {
      std::erase_if(texts_, [&name = name](const std::string& text) { return text.starts_with(name + "="); });
      texts_.push_back(name + "=" + value);
    }
    for (std::string& text : texts_) pointers_.push_back(text.data());
    pointers_.push_back(nullptr);
  }
  char** get() { return pointers_.data(); }

 private:
  std::vector<std::string> texts_;
  std::vector<char*> pointers_;
};

void set_limit(decltype(RLIMIT_AS) what, rlim_t value) {
  const rlimit limit = {value, value};
  (void)setrlimit(what, &limit);
}

/// After fork: only what is safe where other threads may have held a lock.
[[noreturn]] void become_command(const char* command, char** environment, const ChildLimits& limits,
                                 const Pipe& out, const Pipe& err) {
  setpgid(0, 0);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(out.write_end(), STDOUT_FILENO);
  dup2(err.write_end(), STDERR_FILENO);
  set_limit(RLIMIT_CORE, 0);
#ifndef __SANITIZE_ADDRESS__
  set_limit(RLIMIT_AS, static_cast<rlim_t>(limits.memory));
#else
  (void)limits;
#endif
  const std::array<const char*, 4> words = {"/bin/sh", "-c", command, nullptr};
  execve(words[0], const_cast<char* const*>(words.data()), environment);
  constexpr int cannot_run = 126;
  _exit(cannot_run);
}

/// Takes what there is to read. Returns false at the end.
bool take(int end, std::string& text) {
  std::array<char, 65536> bytes{};
  const ssize_t count = read(end, bytes.data(), bytes.size());
  if (count > 0) text.append(bytes.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && errno == EINTR);
}

/// Keeps the last lines only.
void shorten(std::string& text) {
  constexpr std::size_t most = 2000;
  if (text.size() > 2 * most) text.erase(0, text.size() - most);
}

std::string how_it_ended(int status) {
  if (WIFSIGNALED(status)) {
    return std::string("it crashed (") + strsignal(WTERMSIG(status)) + ")";
  }
  const int code = WEXITSTATUS(status);
  constexpr int by_signal = 128;  // of the last command of the shell
  if (code > by_signal && code < by_signal + 65)
    return std::string("it crashed (") + strsignal(code - by_signal) + ")";
  return code == 0 ? "" : "it ended with exit code " + std::to_string(code);
}

}  // namespace

ChildRun run_command(const std::string& command,
                     const std::vector<std::pair<std::string, std::string>>& variables,
                     const ChildLimits& limits, const Progress& progress) {
  ChildRun run;
  Environment environment(variables);
  Pipe out;
  Pipe err;
  const Clock::time_point start = Clock::now();
  const auto seconds = [start] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  const pid_t child = fork();
  if (child < 0) throw InputError(std::string("no new process: ") + std::strerror(errno));
  if (child == 0) become_command(command.c_str(), environment.get(), limits, out, err);
  setpgid(child, child);  // also here, as nobody knows which of the two comes first
  out.close_end(1);
  err.close_end(1);
  std::array<pollfd, 2> ends = {pollfd{out.read_end(), POLLIN, 0}, pollfd{err.read_end(), POLLIN, 0}};
  while (ends[0].fd >= 0 || ends[1].fd >= 0) {
    if (!report_progress(progress, "running the program", seconds() / limits.seconds))
      run.ended = "it was stopped";
    if (seconds() > limits.seconds)
      run.ended = "it took longer than " + significant(limits.seconds, 3) + " s and was ended";
    if (run.out.size() > limits.output) run.ended = "it wrote more than a picture needs and was ended";
    if (!run.ended.empty()) break;
    constexpr int patience_ms = 20;
    if (poll(ends.data(), ends.size(), patience_ms) <= 0) continue;
    if (ends[0].revents != 0 && !take(ends[0].fd, run.out)) ends[0].fd = -1;
    if (ends[1].revents != 0 && !take(ends[1].fd, run.err)) ends[1].fd = -1;
    shorten(run.err);
  }
  // A command may close its outputs and go on.
  int status = 0;
  while (run.ended.empty() && waitpid(child, &status, WNOHANG) == 0) {
    if (seconds() > limits.seconds)
      run.ended = "it took longer than " + significant(limits.seconds, 3) + " s and was ended";
    usleep(1000);
  }
  kill(-child, SIGKILL);
  if (run.ended.empty()) {
    run.ended = how_it_ended(status);
  } else {
    waitpid(child, &status, 0);
  }
  run.seconds = seconds();
  return run;
}

}  // namespace hsr
