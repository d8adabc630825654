// SPDX-License-Identifier: Apache-2.0
// A `vug render` that stays open and renders parts of one picture, one after the other.
#pragma once

#include "part_requests.h"

#include <sys/types.h>
#include <vug/base/progress.h>
#include <vug/farm/job.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vug::cli {

/// The call of `vug` that a task shares with the other parts of its picture, and the request for
/// its part.
struct SharedCall {
  std::vector<std::string> arguments;  ///< Equal for tasks that one process can run.
  PartRequest request;
};

/// Nothing for tasks that are not parts by samples with a guiding file.
std::optional<SharedCall> shared_call(const farm::Task& task);

/// The process. It ends with this object.
class PartProcess {
 public:
  /// Runs this program in `folder` with messages in `log`. Error(bad_input) if it cannot be
  /// started.
  PartProcess(std::vector<std::string> arguments, const std::filesystem::path& folder,
              const std::filesystem::path& log);
  ~PartProcess();
  PartProcess(const PartProcess&) = delete;
  PartProcess& operator=(const PartProcess&) = delete;

  const std::vector<std::string>& arguments() const { return arguments_; }

  /// Renders a part and returns the exit code of `vug render`; if the process ended instead, its
  /// exit code, or 128 + signal number. Error(cancelled) if `progress` is cancelled, after the
  /// process has saved its samples.
  int render(const PartRequest& request, const Progress& progress);
  bool has_ended() const { return exit_.has_value(); }

 private:
  int wait_for_exit();

  std::vector<std::string> arguments_;
  pid_t child_ = 0;
  int socket_ = -1;
  std::string read_;         ///< Answers that are not complete.
  std::optional<int> exit_;  ///< Exit code of the process, once it has ended.
};

}  // namespace vug::cli
