// SPDX-License-Identifier: Apache-2.0
#include "farm/worker.h"

#include "process.h"
#include "verb.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vug/base/memory.h>
#include <vug/base/pluralize.h>
#include <vug/farm/claim.h>

#include <chrono>
#include <csignal>
#include <limits>
#include <optional>
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

Ending ending_of(int exit) {
  if (exit == kDone) return Ending::done;
  if (exit == kUnusable) return Ending::unusable;
  return exit == 128 + SIGKILL ? Ending::killed : Ending::failed;
}

}  // namespace

struct Worker::Next {
  std::optional<size_t> task;
  bool others = false;  ///< Whether other processes run what is left.
};

void Worker::run_task(size_t index) {
  require_ready(index);
  // The claim is for others.
  const auto claim = farm::Claim::take(job_.state_file(job_.job().tasks.at(index), "claim"));
  run(index);
}

void Worker::run_chunk(const std::vector<size_t>& tasks) {
  std::vector<size_t> of_others;
  std::optional<Error> hopeless, later;
  size_t failures = 0;
  const auto attempt = [&](size_t index) {
    try {
      run_task(index);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::cancelled) throw;
      fmt::print(stderr, "warning: {}: {}\n", error.what(), error.hint());
      (error.code() == ErrorCode::bad_input ? hopeless : later) = error;
      ++failures;
    }
  };
  for (const size_t index : tasks) {
    progress_.check();
    if (job_.state(index) == TaskState::running)
      of_others.push_back(index);
    else
      attempt(index);
  }
  for (const size_t index : of_others) attempt(index);
  if (failures == 0) return;
  if (tasks.size() == 1) throw later ? *later : *hopeless;
  throw Error(
      later ? ErrorCode::io : ErrorCode::bad_input,
      fmt::format("{} of {} are not done", failures, pluralize(tasks.size(), "task")), {},
      later ? "run the same tasks again: those that are done end at once" : "see the warnings");
}

void Worker::run_all() {
  while (!job_.finished()) {
    progress_.check();
    const Next next = next_task();
    if (next.task) {
      run_claimed(*next.task);
    } else if (shared_) {
      shared_.reset();  // its memory may be enough for another task
    } else if (next.others) {
      std::this_thread::sleep_for(kPoll);
    } else {
      throw Error(ErrorCode::bad_input, "the tasks that are left have failed", {},
                  "see which, and their logs: vug farm status " + options_.folder);
    }
  }
}

/// Prefers parts for the process that is open. Tasks that need more memory than there is are left
/// to larger machines.
Worker::Next Worker::next_task() const {
  const farm::Job& job = job_.job();
  std::vector<bool> finished;  // Spares requests to a shared folder for each part.
  for (const farm::Picture& each : job.pictures) finished.push_back(job_.finished(each));
  Next next;
  for (size_t i = 0; i < job.tasks.size(); ++i) {
    const Task& task = job.tasks[i];
    if (task.part_of && finished[*task.part_of]) continue;
    const bool shared = is_shared(task);
    if (next.task && !shared) continue;
    const TaskState state = job_.state(i);
    const bool fits = state == TaskState::ready &&
                      (shared || memory_of(task) <= static_cast<double>(available_memory()));
    if (fits || (state == TaskState::done && waits_for_merge(task))) {
      if (!shared_ || shared) return {i};
      next.task = i;
    }
    next.others |= state == TaskState::running;
  }
  return next;
}

/// Whether the task that made the last part was lost before the merge.
bool Worker::waits_for_merge(const Task& task) const {
  if (!task.part_of) return false;
  const farm::Picture& picture = job_.job().pictures[*task.part_of];
  return !job_.finished(picture) && job_.complete(picture);
}

/// The estimate, doubled by each run that was killed.
double Worker::memory_of(const Task& task) const {
  double bytes = task.bytes;
  for (const farm::Run& run : job_.runs(task))
    if (run.ending == Ending::killed) bytes *= 2;
  return bytes;
}

/// Whether the process that is open can run the task.
bool Worker::is_shared(const Task& task) const {
  if (!shared_) return false;
  const auto call = shared_call(task);
  return call && with_threads(call->arguments) == shared_->arguments();
}

/// Error(bad_input) for a task that failed for good, and Error(io) for one that must wait.
void Worker::require_ready(size_t index) const {
  const Task& task = job_.job().tasks.at(index);
  const TaskState state = job_.state(index);
  if (state == TaskState::waiting)
    throw Error(
        ErrorCode::io,
        fmt::format("task {} waits for {}", task.name, job_.job().tasks[task.needs.front()].name),
        {}, "run it again later");
  if (state != TaskState::failed) return;
  const bool hopeless = job_.runs(task).back().ending == Ending::unusable;
  throw Error(ErrorCode::bad_input,
              hopeless ? fmt::format("task {} cannot work", task.name)
                       : fmt::format("task {} failed {} times", task.name, farm::kMostFailures),
              {},
              fmt::format("see {}; to try again, remove {}", job_.state_file(task, "log").string(),
                          job_.state_file(task, "runs").string()));
}

void Worker::run(size_t index) {
  const Task& task = job_.job().tasks.at(index);
  if (task.part_of && job_.finished(job_.job().pictures[*task.part_of])) return;
  if (!job_.made(task)) make(task);
  if (task.part_of) merge(job_.job().pictures[*task.part_of]);
}

/// Other tasks may still work if this one fails.
void Worker::run_claimed(size_t index) {
  const auto claim = farm::Claim::take(job_.state_file(job_.job().tasks[index], "claim"));
  if (!claim) return;
  try {
    run(index);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::cancelled) throw;
    fmt::print(stderr, "warning: {}: {}\n", error.what(), error.hint());
  }
}

void Worker::make(const Task& task) {
  report("running " + task.name);
  const fs::path log = job_.state_file(task, "log");
  std::error_code ignored;
  fs::create_directories(log.parent_path(), ignored);
  const auto start = std::chrono::steady_clock::now();
  const Ending ending = call(task, log);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  job_.add_run(task, {ending, seconds.count(), farm::this_process()});
  require_done(ending, "task " + task.name, log);
}

Ending Worker::call(const Task& task, const fs::path& log) {
  if (auto shared = shared_call(task)) return call_shared(std::move(*shared), log);
  shared_.reset();  // before the memory of the next process is needed
  return call(with_threads(task.arguments), log);
}

std::vector<std::string> Worker::with_threads(std::vector<std::string> arguments) const {
  if (options_.threads > 0)
    arguments.insert(arguments.end(), {"--threads", std::to_string(options_.threads)});
  return arguments;
}

/// Runs the program with these arguments in the folder of the job.
Ending Worker::call(std::vector<std::string> arguments, const fs::path& log) {
  arguments.insert(arguments.begin(), current_executable().string());
  try {
    return ending_of(run_program(arguments, job_.path(), log, kNoLimit, progress_).exit);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::cancelled) throw;
    return Ending::stopped;
  }
}

/// Runs a part in the process that is open, or in a new one.
Ending Worker::call_shared(SharedCall call, const fs::path& log) {
  call.arguments = with_threads(std::move(call.arguments));
  if (shared_ && shared_->arguments() == call.arguments) {
    call.request.log = log.string();
  } else {
    shared_.reset();
    shared_ = std::make_unique<PartProcess>(std::move(call.arguments), job_.path(), log);
  }
  Ending ending = Ending::stopped;
  try {
    ending = ending_of(shared_->render(call.request, progress_));
  } catch (const Error& error) {
    shared_.reset();
    if (error.code() != ErrorCode::cancelled) throw;
    return Ending::stopped;
  }
  if (shared_->has_ended()) shared_.reset();
  return ending;
}

/// The process that made the last part merges all.
void Worker::merge(const farm::Picture& picture) {
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

void Worker::require_done(Ending ending, const std::string& what, const fs::path& log) const {
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

void Worker::fail(ErrorCode code, const std::string& message, const std::string& hint) const {
  if (options_.openjd) fmt::print("openjd_fail: {}: {}\n", message, hint);
  std::fflush(stdout);
  throw Error(code, message, {}, hint);
}

void Worker::report(const std::string& text) const {
  if (!options_.openjd) return fmt::print(stderr, "{}\n", text);
  fmt::print("openjd_status: {}\n", text);
  std::fflush(stdout);
}

}  // namespace vug::cli
