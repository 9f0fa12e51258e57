#include "bench/peer_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <utility>

#include "scene/errors.h"

extern char** environ;

namespace hsr::bench {
namespace {

/// A pipe whose ends are closed with it, and which no other child inherits.
class Pipe {
 public:
  Pipe() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) throw InputError("no pipe to another program can be made");
  }
  ~Pipe() {
    for (const int end : ends_) {
      if (end >= 0) close(end);
    }
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int reading() const { return ends_[0]; }
  int writing() const { return ends_[1]; }
  void close_reading() { close(std::exchange(ends_[0], -1)); }
  void close_writing() { close(std::exchange(ends_[1], -1)); }

 private:
  std::array<int, 2> ends_{-1, -1};
};

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

class PeerProcess : public Contestant {
 public:
  PeerProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
              const std::vector<std::string>& environment, int width, int height)
      : name_(program.filename().string()), width_(width), height_(height) {
    signal(SIGPIPE, SIG_IGN);  // a peer that ended is found when its answer is missing
    start(program, arguments, environment);
    prepare_ms_ = number(answer("ready"));
  }

  ~PeerProcess() override {
    to_peer_.close_writing();
    if (process_ > 0) waitpid(process_, nullptr, 0);
  }

  double run() override {
    tell("run\n");
    return number(answer("ran"));
  }

  Frame picture() override {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("hsr-peer-" + std::to_string(process_));
    tell("picture " + file.string() + "\n");
    (void)answer("picture");
    Frame frame = Frame::without_colors(width_, height_);
    std::ifstream bytes(file, std::ios::binary);
    const auto size = static_cast<std::streamsize>(frame.pixel_count() * sizeof(std::uint32_t));
    bytes.read(reinterpret_cast<char*>(frame.id.data()), size);
    bytes.read(reinterpret_cast<char*>(frame.depth.data()), size);
    std::filesystem::remove(file);
    if (!bytes) throw InputError(name_ + ": its picture is cut off");
    return frame;
  }

  double prepare_ms() const override { return prepare_ms_; }

 private:
  void start(const std::filesystem::path& program, const std::vector<std::string>& arguments,
             const std::vector<std::string>& environment) {
    std::vector<std::string> words = {program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<std::string> variables = environment;
    for (char** variable = environ; *variable != nullptr; ++variable) variables.emplace_back(*variable);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, to_peer_.reading(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, from_peer_.writing(), STDOUT_FILENO);
    const int failed = posix_spawn(&process_, program.c_str(), &files, nullptr, pointers(words).data(),
                                   pointers(variables).data());
    posix_spawn_file_actions_destroy(&files);
    if (failed != 0) {
      process_ = -1;
      throw InputError("cannot start " + program.string());
    }
    to_peer_.close_reading();
    from_peer_.close_writing();
  }

  void tell(const std::string& text) {
    if (write(to_peer_.writing(), text.data(), text.size()) != static_cast<ssize_t>(text.size())) {
      throw InputError(name_ + " ended unexpectedly");
    }
  }

  // What stands after the word in the peer's next line. Throws InputError if it says anything else.
  std::string answer(const std::string& word) {
    std::string line;
    char letter = 0;
    while (true) {
      const ssize_t count = read(from_peer_.reading(), &letter, 1);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) throw InputError(name_ + " ended unexpectedly");
      if (letter == '\n') break;
      line += letter;
    }
    if (!line.starts_with(word + " ")) throw InputError(name_ + ": " + line);
    return line.substr(word.size() + 1);
  }

  double number(const std::string& text) const {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
      throw InputError(name_ + ": \"" + text + "\" is no time");
    }
    return value;
  }

  std::string name_;
  int width_;
  int height_;
  Pipe to_peer_;
  Pipe from_peer_;
  pid_t process_ = -1;
  double prepare_ms_ = 0.0;
};

}  // namespace

std::unique_ptr<Contestant> start_peer(const std::filesystem::path& program,
                                       const std::vector<std::string>& arguments,
                                       const std::vector<std::string>& environment, int width, int height) {
  return std::make_unique<PeerProcess>(program, arguments, environment, width, height);
}

}  // namespace hsr::bench
