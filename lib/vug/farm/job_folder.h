// SPDX-License-Identifier: Apache-2.0
// The progress of a job in its folder, which all machines share. All of it is in files, so that no
// server is needed:
//   job.json           the job
//   NAME.exr           finished pictures
//   parts/             partial renders and learned light
//   state/TASK.runs    one line for each run of a task that has ended
//   state/TASK.claim   exists while the task runs; its time is that of the last heartbeat
//   state/TASK.log     output of the last run
#pragma once

#include <vug/farm/job.h>

#include <chrono>

namespace vug::farm {

enum class TaskState {
  waiting,  ///< A task that it needs has not ended.
  ready,
  running,  ///< Someone runs it and is alive.
  done,     ///< Its file exists.
  failed,   ///< It failed too often, or can never work.
};

/// How a run of a task ended.
enum class Ending {
  done,
  stopped,   ///< On request; its checkpoint allows it to continue.
  failed,    ///< Another run may succeed.
  killed,    ///< By SIGKILL, probably because the memory was exhausted.
  unusable,  ///< No run can succeed.
};

/// A run of a task that has ended.
struct Run {
  Ending ending = Ending::failed;
  double seconds = 0;
  std::string where;  ///< Host and process.
};

inline constexpr int kMostFailures = 3;
/// A process that runs a task touches its claim this often; without a beat for the second time, it
/// is dead.
inline constexpr std::chrono::seconds kHeartbeat{2}, kDeadAfter{10};

class JobFolder {
 public:
  /// Reads the job. Throws as read_job does.
  explicit JobFolder(std::filesystem::path folder);

  const std::filesystem::path& path() const { return folder_; }
  const Job& job() const { return job_; }

  /// A file of the job.
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  std::filesystem::path state_file(const Task& task, const std::string& ending) const;

  bool made(const Task& task) const;
  bool finished(const Picture& picture) const;
  /// Whether all parts of the picture exist.
  bool complete(const Picture& picture) const;
  /// Whether all pictures are finished.
  bool finished() const;
  TaskState state(size_t task) const;

  std::vector<Run> runs(const Task& task) const;
  void add_run(const Task& task, const Run& run) const;

  /// Removes the parts of the picture that are damaged, and returns their names.
  std::vector<std::string> remove_damaged_parts(const Picture& picture) const;

 private:
  std::filesystem::path folder_;
  Job job_;
};

/// Whether the claim exists and its process is alive.
bool is_alive(const std::filesystem::path& claim);

const char* name_of(TaskState state);
const char* name_of(Ending ending);

}  // namespace vug::farm
