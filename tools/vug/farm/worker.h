// SPDX-License-Identifier: Apache-2.0
// Runs tasks of a job in child processes, of which parts of one picture share one.
#pragma once

#include "farm/part_process.h"

#include <vug/base/error.h>
#include <vug/base/progress.h>
#include <vug/farm/job_folder.h>

#include <memory>
#include <string>
#include <vector>

namespace vug::cli {

struct WorkerOptions {
  std::string folder;   ///< Folder of the job, for messages.
  bool openjd = false;  ///< Messages in the form of OpenJD.
  int threads = 0;      ///< Threads of each child process; 0: all cores.
};

/// Errors have the exit code of `vug farm run`: bad_input, 2, if a task can never work, and io, 3,
/// if another run may succeed.
class Worker {
 public:
  Worker(const farm::JobFolder& job, WorkerOptions options, Progress& progress)
      : job_(job), options_(std::move(options)), progress_(progress) {}

  /// Runs the task, also if another process does: a second run is harmless. Does nothing if its
  /// file exists. Merges its picture if it was the last part.
  void run_task(size_t index);
  /// Runs a chunk: its tasks in turn, and those that other processes run at the end. A task that
  /// fails does not prevent the following ones.
  void run_chunk(const std::vector<size_t>& tasks);
  /// Runs the tasks that no other process runs, until all pictures are finished or only failed
  /// tasks are left.
  void run_all();

 private:
  struct Next;
  Next next_task() const;
  bool waits_for_merge(const farm::Task& task) const;
  double memory_of(const farm::Task& task) const;
  bool is_shared(const farm::Task& task) const;
  void require_ready(size_t index) const;
  void run(size_t index);
  void run_claimed(size_t index);
  void make(const farm::Task& task);
  farm::Ending call(const farm::Task& task, const std::filesystem::path& log);
  farm::Ending call(std::vector<std::string> arguments, const std::filesystem::path& log);
  farm::Ending call_shared(SharedCall call, const std::filesystem::path& log);
  std::vector<std::string> with_threads(std::vector<std::string> arguments) const;
  void merge(const farm::Picture& picture);
  void require_done(farm::Ending ending, const std::string& what,
                    const std::filesystem::path& log) const;
  [[noreturn]] void fail(ErrorCode code, const std::string& message, const std::string& hint) const;
  void report(const std::string& text) const;

  const farm::JobFolder& job_;
  WorkerOptions options_;
  Progress& progress_;
  std::unique_ptr<PartProcess> shared_;  ///< That of the last part; null: none.
};

}  // namespace vug::cli
