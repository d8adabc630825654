// SPDX-License-Identifier: Apache-2.0
// `vug farm run`: runs a task of a job, a chunk of them, or all that no other process runs.
#include "arguments.h"
#include "farm/worker.h"
#include "progress_bar.h"

#include <fmt/format.h>
#include <vug/farm/task_list.h>

#include <memory>
#include <optional>

namespace vug::cli {
namespace {

namespace fs = std::filesystem;

struct RunOptions {
  WorkerOptions worker;
  std::optional<size_t> task;
  std::string tasks;
};

int run_tasks(const RunOptions& options) {
  const farm::JobFolder job(fs::absolute(options.worker.folder));
  farm::require_inputs(job.job());
  Worker worker(job, options.worker, terminal_progress(ProgressBarMode::never));
  if (!options.task && options.tasks.empty()) {
    worker.run_all();
    return kDone;
  }
  std::vector<size_t> tasks;
  if (options.task) tasks.push_back(*options.task);
  if (!options.tasks.empty()) tasks = farm::parse_tasks(options.tasks);
  const size_t count = job.job().tasks.size();
  for (const size_t each : tasks)
    if (each >= count)
      throw Error(ErrorCode::bad_input, fmt::format("the job has no task {}", each), {},
                  fmt::format("its tasks are 0 to {}", count - 1));
  if (options.task)
    worker.run_task(*options.task);
  else
    worker.run_chunk(tasks);
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
            WorkerOptions& worker = options->worker;
            app.add_option("job", worker.folder, "Folder of the job")->required();
            auto* task = app.add_option(
                "--task", options->task,
                "Number of the only task to run; default all that no other process runs, "
                "until the pictures are finished");
            app.add_option("--tasks", options->tasks,
                           "Numbers of the tasks of a chunk, which run in turn: N-M, N-M:STEP, or "
                           "several separated by commas; parts of one picture share a process")
                ->excludes(task);
            app.add_option("--threads", worker.threads, "Threads of a task; default all cores")
                ->check(integer_in(0, 1024));
            app.add_option("--progress", *format, "Form of the messages: plain or openjd")
                ->check(one_of({"plain", "openjd"}));
            return [options, format] {
              options->worker.openjd = *format == "openjd";
              return run_tasks(*options);
            };
          }};
}

}  // namespace vug::cli
