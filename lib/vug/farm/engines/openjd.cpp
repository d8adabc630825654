// SPDX-License-Identifier: Apache-2.0
// https://github.com/OpenJobDescription/openjd-specifications/wiki/2023-09-Template-Schemas
#include <vug/farm/engine_files.h>

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace vug::farm {
namespace {

using Json = nlohmann::ordered_json;

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
         {"farm", "run", "{{Param.Job}}", "--task", "{{Task.Param.Task}}", "--progress", "openjd",
          "--threads", std::to_string(options.cores)}},
        {"cancelation", {{"mode", "NOTIFY_THEN_TERMINATE"}, {"notifyPeriodInSeconds", 60}}}};
    Json step = {{"name", fmt::format("level {}", steps.size())}};
    if (!steps.empty())
      step["dependencies"] = Json::array({{{"dependsOn", steps.back().at("name")}}});
    step["parameterSpace"] = {
        {"taskParameterDefinitions",
         Json::array({{{"name", "Task"}, {"type", "INT"}, {"range", range_text(ranges)}}})}};
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
  const Json whole = {{"specificationVersion", "jobtemplate-2023-09"},
                      {"name", "vug"},
                      {"parameterDefinitions", parameters},
                      {"steps", std::move(steps)}};
  return {"openjd.json", whole.dump(1) + "\n", false, "submit openjd.json"};
}

}  // namespace vug::farm
