#include "support/run_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <sstream>
#include <stdexcept>

#include "support/temporary_folder.h"

namespace hsr::test {
namespace {

/// `text` without the lines that tell how far the work is: "rendering: 42 %".
std::string without_progress(const std::string& text) {
  std::istringstream lines(text);
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    if (!line.ends_with(" %")) kept += line + "\n";
  }
  return kept;
}

ProgramRun run_command(std::vector<std::string> words) {
  const TemporaryFolder folder;
  const std::string out = folder / "out";
  const std::string err = folder / "err";
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);

  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_addopen(&streams, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&streams, STDOUT_FILENO, out.c_str(), O_CREAT | O_WRONLY, 0600);
  posix_spawn_file_actions_addopen(&streams, STDERR_FILENO, err.c_str(), O_CREAT | O_WRONLY, 0600);
  pid_t process = 0;
  const int error = posix_spawnp(&process, arguments[0], &streams, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&streams);
  if (error != 0) throw std::runtime_error("cannot run " + words[0]);

  int status = 0;
  if (waitpid(process, &status, 0) != process) throw std::runtime_error("cannot wait for " + words[0]);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(out), without_progress(content_of(err))};
}

}  // namespace

ProgramRun run_program(const std::vector<std::string>& words) {
  std::vector<std::string> command = {HSR_PROGRAM};
  command.insert(command.end(), words.begin(), words.end());
  return run_command(command);
}

ProgramRun run_program_on_full_disk(int kilobytes, const std::vector<std::string>& words) {
  // With the signal ignored, a write beyond the limit fails as on a full disk.
  const std::string script = "ulimit -f " + std::to_string(kilobytes) + "; trap '' XFSZ; exec \"$@\"";
  std::vector<std::string> command = {"sh", "-c", script, "sh", HSR_PROGRAM};
  command.insert(command.end(), words.begin(), words.end());
  return run_command(command);
}

}  // namespace hsr::test
