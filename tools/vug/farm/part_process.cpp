// SPDX-License-Identifier: Apache-2.0
#include "farm/part_process.h"

#include "process.h"
#include "verb.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vug/base/error.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

namespace vug::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// Time that the process has to end once it is asked to.
constexpr std::chrono::seconds kEndTimeout{5};
constexpr std::chrono::milliseconds kPollInterval{5};

/// Both ends of a connection; only the second is open in other programs, as their standard streams.
std::array<int, 2> connection() {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw Error(ErrorCode::io, fmt::format("cannot connect to a process: {}", std::strerror(errno)),
                {}, "run fewer processes at a time");
  return ends;
}

}  // namespace

std::optional<SharedCall> shared_call(const farm::Task& task) {
  SharedCall call;
  bool learned = false;
  const std::vector<std::string>& words = task.arguments;
  for (size_t i = 0; i < words.size(); ++i) {
    const bool has_value = i + 1 < words.size();
    if (words[i] == "--part" && has_value) {
      call.request.part = words[++i];
    } else if (words[i] == "--samples" && has_value) {
      call.request.samples = words[++i];
    } else if (words[i] == "--checkpoint" && has_value) {
      call.request.checkpoint = words[++i];
    } else if (words[i] != "--resume") {
      learned |= words[i] == "--guiding";
      call.arguments.push_back(words[i]);
    }
  }
  if (!task.part_of || !learned || call.request.part.empty() || call.request.samples.empty())
    return std::nullopt;
  call.arguments.emplace_back("--part-requests");
  return call;
}

PartProcess::PartProcess(std::vector<std::string> arguments, const std::filesystem::path& folder,
                         const std::filesystem::path& log)
    : arguments_(std::move(arguments)) {
  std::vector<std::string> command = arguments_;
  command.insert(command.begin(), current_executable().string());
  const std::array<int, 2> ends = connection();
  try {
    child_ =
        start_program(command, folder, log, "check the permissions of the job's folder", ends[1]);
  } catch (...) {
    for (const int end : ends) close(end);
    throw;
  }
  close(ends[1]);
  socket_ = ends[0];
}

PartProcess::~PartProcess() {
  shutdown(socket_, SHUT_WR);  // the end of the requests
  wait_for_exit();
  close(socket_);
}

int PartProcess::render(const PartRequest& request, const Progress& progress) {
  const std::string line = to_line(request) + "\n";
  // A short line fits into the buffer of the connection. If the process has ended, this fails, and
  // so does the poll below.
  const auto exit_without_answer = [&] {
    const int exit = wait_for_exit();
    return exit == kDone ? static_cast<int>(kFailed) : exit;
  };
  if (send(socket_, line.data(), line.size(), MSG_NOSIGNAL) < 0) return exit_without_answer();
  while (true) {
    if (progress.cancelled()) {
      kill(child_, SIGTERM);
      wait_for_exit();
      progress.check();
    }
    if (const size_t end = read_.find('\n'); end != std::string::npos) {
      const std::string answer = read_.substr(0, end);
      read_.erase(0, end + 1);
      return exit_of_answer(answer);
    }
    pollfd waiting{socket_, POLLIN, 0};
    if (poll(&waiting, 1, static_cast<int>(kPollInterval.count())) <= 0) continue;
    std::array<char, 256> buffer{};
    const ssize_t count = recv(socket_, buffer.data(), buffer.size(), 0);
    if (count <= 0) return exit_without_answer();
    read_.append(buffer.data(), static_cast<size_t>(count));
  }
}

/// The exit code. Kills the process if it does not end in time.
int PartProcess::wait_for_exit() {
  const auto end = Clock::now() + kEndTimeout;
  int status = 0;
  while (!exit_) {
    const pid_t ended = waitpid(child_, &status, WNOHANG);
    if (ended == child_)
      exit_ = exit_of_status(status);
    else if (ended < 0 && errno != EINTR)
      exit_ = 128 + SIGKILL;  // someone else has waited for it
    else if (Clock::now() > end)
      kill(child_, SIGKILL);
    if (!exit_) std::this_thread::sleep_for(kPollInterval);
  }
  return *exit_;
}

}  // namespace vug::cli
