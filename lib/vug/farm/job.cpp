// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/hash.h>
#include <vug/base/json_file.h>
#include <vug/farm/job.h>

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace vug::farm {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kPlanAgain = "plan it with: vug farm plan SCENE -o FOLDER";

Json to_json_value(const Task& task) {
  Json out = {{"name", task.name}, {"arguments", task.arguments}, {"makes", task.makes}};
  if (!task.needs.empty()) out["needs"] = task.needs;
  if (task.part_of) out["part_of"] = *task.part_of;
  out["seconds"] = task.seconds;
  out["bytes"] = task.bytes;
  return out;
}

Task task_from(const Json& value) {
  Task task;
  value.at("name").get_to(task.name);
  value.at("arguments").get_to(task.arguments);
  value.at("makes").get_to(task.makes);
  if (value.contains("needs")) value.at("needs").get_to(task.needs);
  if (value.contains("part_of")) task.part_of = value.at("part_of").get<size_t>();
  value.at("seconds").get_to(task.seconds);
  value.at("bytes").get_to(task.bytes);
  return task;
}

/// The first reference to something that does not exist; empty if there is none.
std::string broken_reference(const Job& job) {
  for (size_t i = 0; i < job.tasks.size(); ++i) {
    for (const size_t needed : job.tasks[i].needs)
      if (needed >= i)
        return fmt::format("task {} needs task {}, which is not before it", i, needed);
    if (job.tasks[i].part_of && *job.tasks[i].part_of >= job.pictures.size())
      return fmt::format("task {} is a part of picture {}, which does not exist", i,
                         *job.tasks[i].part_of);
  }
  for (const Picture& picture : job.pictures)
    for (const size_t part : picture.parts)
      if (part >= job.tasks.size()) return fmt::format("task {} does not exist", part);
  return {};
}

}  // namespace

std::string to_json(const Job& job) {
  Json inputs = Json::array(), pictures = Json::array(), tasks = Json::array();
  for (const Input& each : job.inputs)
    inputs.push_back({{"file", each.file}, {"digest", each.digest}});
  for (const Picture& each : job.pictures)
    pictures.push_back({{"file", each.file}, {"parts", each.parts}});
  for (const Task& each : job.tasks) tasks.push_back(to_json_value(each));
  return Json{{"version", job.version},
              {"inputs", std::move(inputs)},
              {"pictures", std::move(pictures)},
              {"tasks", std::move(tasks)}}
             .dump(1) +
         "\n";
}

Job read_job(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kJobFile;
  const auto json = read_json<Json>(file, kPlanAgain);
  Job job;
  try {
    json.at("version").get_to(job.version);
    for (const Json& each : json.at("inputs"))
      job.inputs.push_back(
          {each.at("file").get<std::string>(), each.at("digest").get<std::string>()});
    for (const Json& each : json.at("pictures"))
      job.pictures.push_back(
          {each.at("file").get<std::string>(), each.at("parts").get<std::vector<size_t>>()});
    for (const Json& each : json.at("tasks")) job.tasks.push_back(task_from(each));
  } catch (const nlohmann::json::exception& error) {
    throw Error(ErrorCode::bad_input,
                fmt::format("'{}' is not a job: {}", file.string(), error.what()), {}, kPlanAgain);
  }
  if (const std::string fault = broken_reference(job); !fault.empty())
    throw Error(ErrorCode::bad_input, fmt::format("'{}' is not a job: {}", file.string(), fault),
                {}, kPlanAgain);
  return job;
}

void require_inputs(const Job& job) {
  const char* hint = "plan the job again in a new folder";
  if (job.version != VUG_VERSION)
    throw Error(ErrorCode::bad_input,
                fmt::format("the job was planned by version {}, but this is version {}",
                            job.version, VUG_VERSION),
                {}, hint);
  for (const Input& input : job.inputs)
    if (digest(read_text(input.file)).hex() != input.digest)
      throw Error(ErrorCode::bad_input,
                  fmt::format("'{}' has changed since the job was planned", input.file), {}, hint);
}

}  // namespace vug::farm
