// Another program, run to its end.
#pragma once

#include <vug/base/progress.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vug::cli {

struct ProcessResult {
  int exit = -1;  ///< Its exit code; 128 + the signal's number for one that was killed.
  bool timed_out = false;
};

/// Runs `command` (the first word is the program, found in PATH) in `folder`; what it prints goes
/// to the file `log`. After `seconds` it is killed. Error(bad_input) where it cannot be started,
/// Error(cancelled) where `progress` asks to stop, once it has ended on SIGTERM or SIGKILL.
ProcessResult run_program(const std::vector<std::string>& command,
                          const std::filesystem::path& folder, const std::filesystem::path& log,
                          double seconds, const Progress& progress = Progress::none());

/// The program that is running now.
std::filesystem::path current_executable();

}  // namespace vug::cli
