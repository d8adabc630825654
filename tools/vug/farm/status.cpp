// SPDX-License-Identifier: Apache-2.0
// `vug farm status`: how far a job is.
#include "print.h"
#include "verb.h"

#include <fmt/format.h>
#include <vug/farm/job_folder.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace vug::cli {
namespace {

using farm::Ending;
using farm::JobFolder;
using farm::Task;
using farm::TaskState;
using Json = nlohmann::ordered_json;

struct StatusOptions {
  std::string folder = ".";
  bool json = false;
};

/// Seconds of the run that succeeded; none if the task has not.
std::optional<double> measured_seconds(const JobFolder& job, const Task& task) {
  for (const farm::Run& run : job.runs(task))
    if (run.ending == Ending::done) return run.seconds;
  return std::nullopt;
}

/// Estimated seconds of the work that is left, for one task at a time. The estimates of the plan
/// are corrected by the durations of the tasks that are done.
double seconds_left(const JobFolder& job, const std::vector<TaskState>& states) {
  double planned = 0, measured = 0, left = 0;
  for (size_t i = 0; i < states.size(); ++i) {
    const Task& task = job.job().tasks[i];
    if (states[i] != TaskState::done)
      left += task.seconds;
    else if (const auto seconds = measured_seconds(job, task))
      planned += task.seconds, measured += *seconds;
  }
  return planned > 0 ? left * measured / planned : left;
}

Json report_on(const JobFolder& job) {
  const auto& tasks = job.job().tasks;
  std::vector<TaskState> states(tasks.size());
  for (size_t i = 0; i < tasks.size(); ++i) states[i] = job.state(i);
  Json counts;
  for (const TaskState state : {TaskState::done, TaskState::running, TaskState::ready,
                                TaskState::waiting, TaskState::failed})
    counts[name_of(state)] = std::count(states.begin(), states.end(), state);
  Json unfinished = Json::array();
  for (size_t i = 0; i < tasks.size(); ++i) {
    const std::vector<farm::Run> runs = job.runs(tasks[i]);
    const bool troubled = std::any_of(runs.begin(), runs.end(), [](const farm::Run& run) {
      return run.ending != Ending::done && run.ending != Ending::stopped;
    });
    if (states[i] != TaskState::running && states[i] != TaskState::failed && !troubled) continue;
    Json entry = {{"task", i}, {"name", tasks[i].name}, {"state", name_of(states[i])}};
    if (!runs.empty()) entry["last_run"] = name_of(runs.back().ending);
    if (states[i] == TaskState::failed) entry["log"] = job.state_file(tasks[i], "log").string();
    unfinished.push_back(std::move(entry));
  }
  const auto pictures =
      std::count_if(job.job().pictures.begin(), job.job().pictures.end(),
                    [&](const farm::Picture& picture) { return job.finished(picture); });
  return {{"pictures", job.job().pictures.size()},
          {"finished", pictures},
          {"tasks", std::move(counts)},
          {"seconds_left", std::round(seconds_left(job, states))},
          {"notable", std::move(unfinished)}};
}

}  // namespace

Verb farm_status_verb() {
  return {"status",
          "Reports the finished pictures and the tasks of a job. Exit code 1 while pictures are "
          "missing.",
          [](CLI::App& app) {
            auto options = std::make_shared<StatusOptions>();
            app.add_option("job", options->folder, "Folder of the job")->required();
            app.add_flag("--json", options->json, "Machine-readable output");
            return [options] {
              const JobFolder job(std::filesystem::absolute(options->folder));
              print_report(report_on(job), options->json);
              return job.finished() ? kDone : kAnswerNo;
            };
          }};
}

}  // namespace vug::cli
