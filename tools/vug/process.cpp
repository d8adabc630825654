// SPDX-License-Identifier: Apache-2.0
#include "process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vug/base/error.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>
#include <thread>

namespace vug::cli {
namespace {

/// Actions of the new process before it executes the program.
class SpawnActions {
 public:
  SpawnActions(const std::filesystem::path& folder, const std::filesystem::path& log,
               int connection) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, 2, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (connection < 0) {
      posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
      posix_spawn_file_actions_adddup2(&actions_, 2, 1);
    } else {
      posix_spawn_file_actions_adddup2(&actions_, connection, 0);
      posix_spawn_file_actions_adddup2(&actions_, connection, 1);
    }
    posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
  }
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

/// Time that a program has to end after SIGTERM.
constexpr std::chrono::seconds kTerminationTimeout{5};

}  // namespace

pid_t start_program(const std::vector<std::string>& command, const std::filesystem::path& folder,
                    const std::filesystem::path& log, const std::string& hint, int connection) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const SpawnActions actions(std::filesystem::absolute(folder), std::filesystem::absolute(log),
                             connection);
  pid_t child = 0;
  const int fault = posix_spawnp(&child, words[0], actions.get(), nullptr, words.data(), environ);
  if (fault == 0) return child;
  throw Error(ErrorCode::bad_input,
              fmt::format("cannot run '{}': {}", command.at(0), std::strerror(fault)), {}, hint);
}

int exit_of_status(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

ProcessResult run_program(const std::vector<std::string>& command,
                          const std::filesystem::path& folder, const std::filesystem::path& log,
                          double seconds, const Progress& progress) {
  const pid_t child =
      start_program(command, folder, log, "name a program in PATH, or write {vug} for this one");
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  ProcessResult out;
  int status = 0;
  std::optional<Clock::time_point> asked;  // time of SIGTERM
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (progress.cancelled() && !asked) {
      asked = Clock::now();
      kill(child, SIGTERM);
    }
    if (asked && Clock::now() > *asked + kTerminationTimeout) kill(child, SIGKILL);
    if (Clock::now() > end && !out.timed_out) {
      kill(child, SIGKILL);
      out.timed_out = true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  if (asked) progress.check();
  out.exit = exit_of_status(status);
  return out;
}

std::filesystem::path current_executable() {
  return std::filesystem::read_symlink("/proc/self/exe");
}

}  // namespace vug::cli
