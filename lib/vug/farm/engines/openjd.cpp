// SPDX-License-Identifier: Apache-2.0
// https://github.com/OpenJobDescription/openjd-specifications/wiki/2023-09-Template-Schemas
// Chunks:
// https://github.com/OpenJobDescription/openjd-specifications/blob/mainline/rfcs/0001-task-chunking.md
#include <vug/farm/engine_files.h>

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace vug::farm {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kMostInChunk = 150;  // of the extension TASK_CHUNKING
constexpr double kMebibyte = 1024.0 * 1024.0;

/// "0-7,12": the numbers of a level, which `range` accepts in any quantity.
std::string range_text(const std::vector<std::pair<size_t, size_t>>& ranges) {
  std::string text;
  for (const auto& [first, last] : ranges) {
    if (!text.empty()) text += ',';
    text += first == last ? fmt::format("{}", first) : fmt::format("{}-{}", first, last);
  }
  return text;
}

}  // namespace

EngineFile openjd_file(const Job& job, const EngineOptions& options) {
  Json steps = Json::array();
  double bytes = 0;
  for (const Task& task : job.tasks) bytes = std::max(bytes, task.bytes);
  for (const auto& ranges : levels(job)) {
    const Json run = {
        {"command", "{{Param.Program}}"},
        {"args",
         {"farm", "run", "{{Param.Job}}", "--tasks", "{{Task.Param.Task}}", "--progress", "openjd",
          "--threads", std::to_string(options.cores)}},
        {"cancelation", {{"mode", "NOTIFY_THEN_TERMINATE"}, {"notifyPeriodInSeconds", 60}}}};
    Json step = {{"name", fmt::format("level {}", steps.size())}};
    if (!steps.empty())
      step["dependencies"] = Json::array({{{"dependsOn", steps.back().at("name")}}});
    Json parameter = {{"name", "Task"}, {"type", "INT"}, {"range", range_text(ranges)}};
    if (options.chunk > 1) {  // "--tasks 8-11"
      parameter["type"] = "CHUNK[INT]";
      parameter["chunks"] = {{"defaultTaskCount", std::min(options.chunk, kMostInChunk)},
                             {"rangeConstraint", "CONTIGUOUS"}};
    }
    step["parameterSpace"] = {{"taskParameterDefinitions", Json::array({std::move(parameter)})}};
    step["hostRequirements"] = {
        {"amounts",
         Json::array({{{"name", "amount.worker.vcpu"}, {"min", options.cores}},
                      {{"name", "amount.worker.memory"}, {"min", std::ceil(bytes / kMebibyte)}}})}};
    step["script"] = {{"actions", {{"onRun", run}}}};
    steps.push_back(std::move(step));
  }
  const Json parameters =
      Json::array({{{"name", "Job"},
                    {"type", "PATH"},
                    {"objectType", "DIRECTORY"},
                    {"dataFlow", "INOUT"},
                    {"default", "."}},
                   {{"name", "Program"}, {"type", "STRING"}, {"default", options.program}}});
  Json whole = {{"specificationVersion", "jobtemplate-2023-09"}};
  if (options.chunk > 1) whole["extensions"] = Json::array({"TASK_CHUNKING"});
  whole["name"] = "vug";
  whole["parameterDefinitions"] = parameters;
  whole["steps"] = std::move(steps);
  return {"openjd.json", whole.dump(1) + "\n", false, "submit openjd.json"};
}

}  // namespace vug::farm
