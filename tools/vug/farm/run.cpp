// SPDX-License-Identifier: Apache-2.0
// `vug farm run`: runs a task of a job, or all that no other process runs.
#include "arguments.h"
#include "process.h"
#include "progress_bar.h"
#include "scene_options.h"

#include <fmt/format.h>
#include <vug/base/error.h>
#include <vug/base/memory.h>
#include <vug/farm/claim.h>
#include <vug/farm/job_folder.h>

#include <chrono>
#include <csignal>
#include <limits>
#include <memory>
#include <thread>

namespace vug::cli {
namespace {

namespace fs = std::filesystem;
using farm::Ending;
using farm::JobFolder;
using farm::Task;
using farm::TaskState;

constexpr double kNoLimit = std::numeric_limits<double>::max();
constexpr std::chrono::milliseconds kPoll{500};

struct RunOptions {
  std::string folder = ".";
  std::optional<size_t> task;
  bool openjd = false;
  int threads = 0;
};

/// Runs the tasks of a job in child processes. Errors of tasks have the exit code of the verb: 2 if
/// they can never work, 3 if another run may succeed.
class Worker {
 public:
  Worker(const JobFolder& job, const RunOptions& options, Progress& progress)
      : job_(job), options_(options), progress_(progress) {}

  /// Runs the task unless its file exists, and merges its picture if it was the last part.
  void run(size_t index) {
    const Task& task = job_.job().tasks.at(index);
    if (!job_.made(task)) make(task);
    if (task.part_of) merge(job_.job().pictures[*task.part_of]);
  }

  /// Runs tasks until all pictures are finished or only failed tasks are left.
  void run_all() {
    while (!job_.finished()) {
      progress_.check();
      const Next next = next_task();
      if (next.task) {
        run_claimed(*next.task);
      } else if (next.others) {
        std::this_thread::sleep_for(kPoll);
      } else {
        throw Error(ErrorCode::bad_input, "the tasks that are left have failed", {},
                    "see which, and their logs: vug farm status " + options_.folder);
      }
    }
  }

 private:
  struct Next {
    std::optional<size_t> task;
    bool others = false;  ///< Whether other processes run what is left.
  };

  /// Tasks that need more memory than there is are left to larger machines.
  Next next_task() const {
    const farm::Job& job = job_.job();
    std::vector<bool> finished;  // Spares requests to a shared folder for each part.
    for (const farm::Picture& each : job.pictures) finished.push_back(job_.finished(each));
    Next next;
    for (size_t i = 0; i < job.tasks.size(); ++i) {
      const Task& task = job.tasks[i];
      if (task.part_of && finished[*task.part_of]) continue;
      const TaskState state = job_.state(i);
      const bool fits =
          state == TaskState::ready && memory_of(task) <= static_cast<double>(available_memory());
      if (fits || (state == TaskState::done && waits_for_merge(task))) return {i};
      next.others |= state == TaskState::running;
    }
    return next;
  }

  /// Whether the task that made the last part was lost before the merge.
  bool waits_for_merge(const Task& task) const {
    if (!task.part_of) return false;
    const farm::Picture& picture = job_.job().pictures[*task.part_of];
    return !job_.finished(picture) && job_.complete(picture);
  }

  /// The estimate, doubled by each run that was killed.
  double memory_of(const Task& task) const {
    double bytes = task.bytes;
    for (const farm::Run& run : job_.runs(task))
      if (run.ending == Ending::killed) bytes *= 2;
    return bytes;
  }

  /// Other tasks may still work if this one fails.
  void run_claimed(size_t index) {
    const auto claim = farm::Claim::take(job_.state_file(job_.job().tasks[index], "claim"));
    if (!claim) return;
    try {
      run(index);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::cancelled) throw;
      fmt::print(stderr, "warning: {}: {}\n", error.what(), error.hint());
    }
  }

  void make(const Task& task) {
    std::vector<std::string> arguments = task.arguments;
    if (options_.threads > 0)
      arguments.insert(arguments.end(), {"--threads", std::to_string(options_.threads)});
    report("running " + task.name);
    const fs::path log = job_.state_file(task, "log");
    const auto start = std::chrono::steady_clock::now();
    const Ending ending = call(std::move(arguments), log);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    job_.add_run(task, {ending, seconds.count(), farm::this_process()});
    require_done(ending, "task " + task.name, log);
  }

  /// The process that made the last part merges all.
  void merge(const farm::Picture& picture) {
    if (job_.finished(picture) || !job_.complete(picture)) return;
    const fs::path state = job_.path() / "state" / (picture.file + ".merge");
    const farm::FileLock lock(state.string() + ".lock");
    if (job_.finished(picture)) return;
    std::vector<std::string> arguments{"merge", "--quiet"};
    for (const size_t part : picture.parts) arguments.push_back(job_.job().tasks[part].makes);
    arguments.insert(arguments.end(), {"-o", picture.file});
    report("merging " + picture.file);
    const fs::path log = state.string() + ".log";
    const Ending ending = call(std::move(arguments), log);
    if (ending != Ending::done && ending != Ending::stopped)
      if (const auto damaged = job_.remove_damaged_parts(picture); !damaged.empty())
        fail(ErrorCode::io,
             fmt::format("'{}' was damaged, and was removed", fmt::join(damaged, "', '")),
             "run the job again: the missing parts are made again");
    require_done(ending, "the merge of " + picture.file, log);
  }

  Ending call(std::vector<std::string> arguments, const fs::path& log) {
    arguments.insert(arguments.begin(), current_executable().string());
    std::error_code ignored;
    fs::create_directories(log.parent_path(), ignored);
    try {
      const int exit = run_program(arguments, job_.path(), log, kNoLimit, progress_).exit;
      if (exit == kDone) return Ending::done;
      if (exit == kUnusable) return Ending::unusable;
      return exit == 128 + SIGKILL ? Ending::killed : Ending::failed;
    } catch (const Error& error) {
      if (error.code() != ErrorCode::cancelled) throw;
      return Ending::stopped;
    }
  }

  void require_done(Ending ending, const std::string& what, const fs::path& log) const {
    const std::string see = "see " + log.string();
    switch (ending) {
      case Ending::done:
        return;
      case Ending::stopped:
        return progress_.check();
      case Ending::unusable:
        return fail(ErrorCode::bad_input, what + " cannot work", see);
      case Ending::failed:
        return fail(ErrorCode::io, what + " failed", see);
      case Ending::killed:
        return fail(ErrorCode::io, what + " was killed, probably because of its memory",
                    "run it on a machine with more memory; " + see);
    }
  }

  [[noreturn]] void fail(ErrorCode code, const std::string& message,
                         const std::string& hint) const {
    if (options_.openjd) fmt::print("openjd_fail: {}: {}\n", message, hint);
    std::fflush(stdout);
    throw Error(code, message, {}, hint);
  }

  void report(const std::string& text) const {
    if (!options_.openjd) return fmt::print(stderr, "{}\n", text);
    fmt::print("openjd_status: {}\n", text);
    std::fflush(stdout);
  }

  const JobFolder& job_;
  const RunOptions& options_;
  Progress& progress_;
};

/// Error(bad_input) for a task that failed for good, and Error(io) for one that must wait.
void require_ready(const JobFolder& job, size_t index) {
  const Task& task = job.job().tasks[index];
  const TaskState state = job.state(index);
  if (state == TaskState::waiting)
    throw Error(
        ErrorCode::io,
        fmt::format("task {} waits for {}", task.name, job.job().tasks[task.needs.front()].name),
        {}, "run it again later");
  if (state != TaskState::failed) return;
  const bool hopeless = job.runs(task).back().ending == Ending::unusable;
  throw Error(ErrorCode::bad_input,
              hopeless ? fmt::format("task {} cannot work", task.name)
                       : fmt::format("task {} failed {} times", task.name, farm::kMostFailures),
              {},
              fmt::format("see {}; to try again, remove {}", job.state_file(task, "log").string(),
                          job.state_file(task, "runs").string()));
}

int run_tasks(const RunOptions& options) {
  const JobFolder job(fs::absolute(options.folder));
  farm::require_inputs(job.job());
  Worker worker(job, options, terminal_progress(ProgressBarMode::never));
  if (!options.task) {
    worker.run_all();
    return kDone;
  }
  const auto& tasks = job.job().tasks;
  if (*options.task >= tasks.size())
    throw Error(ErrorCode::bad_input, fmt::format("the job has no task {}", *options.task), {},
                fmt::format("its tasks are 0 to {}", tasks.size() - 1));
  require_ready(job, *options.task);
  // The claim is for others. A second run of the same task is harmless.
  const auto claim = farm::Claim::take(job.state_file(tasks[*options.task], "claim"));
  worker.run(*options.task);
  return kDone;
}

}  // namespace

Verb farm_run_verb() {
  return {"run",
          "Runs tasks of a job, and merges each picture after its last part. Exit codes: 0 done, 2 "
          "will never work, 3 run again.",
          [](CLI::App& app) {
            auto options = std::make_shared<RunOptions>();
            auto format = std::make_shared<std::string>("plain");
            app.add_option("job", options->folder, "Folder of the job")->required();
            app.add_option(
                "--task", options->task,
                "Number of the only task to run; default all that no other process runs, "
                "until the pictures are finished");
            app.add_option("--threads", options->threads, "Threads of a task; default all cores")
                ->check(integer_in(0, 1024));
            app.add_option("--progress", *format, "Form of the messages: plain or openjd")
                ->check(one_of({"plain", "openjd"}));
            return [options, format] {
              options->openjd = *format == "openjd";
              return run_tasks(*options);
            };
          }};
}

}  // namespace vug::cli
