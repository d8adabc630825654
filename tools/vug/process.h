// SPDX-License-Identifier: Apache-2.0
// Runs another program to its end.
#pragma once

#include <sys/types.h>
#include <vug/base/progress.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vug::cli {

/// How a process ended.
struct ProcessResult {
  int exit = -1;  ///< Exit code; 128 + signal number for a process that was killed.
  bool timed_out = false;
};

/// Runs `command` (the first word is the program, searched in PATH) in `folder` and writes its
/// output to the file `log`. Kills it after `seconds`. Error(bad_input) if it cannot be started;
/// Error(cancelled) if `progress` is cancelled, after the process has ended on SIGTERM or SIGKILL.
ProcessResult run_program(const std::vector<std::string>& command,
                          const std::filesystem::path& folder, const std::filesystem::path& log,
                          double seconds, const Progress& progress = Progress::none());

/// Starts a program as run_program does. `connection`: a descriptor that becomes its standard input
/// and output, instead of the null device and the log; -1: none. Error(bad_input) with the hint if
/// it cannot be started.
pid_t start_program(const std::vector<std::string>& command, const std::filesystem::path& folder,
                    const std::filesystem::path& log, const std::string& hint, int connection = -1);

/// ProcessResult::exit from the status of waitpid.
int exit_of_status(int status);

/// Path of the running executable.
std::filesystem::path current_executable();

}  // namespace vug::cli
