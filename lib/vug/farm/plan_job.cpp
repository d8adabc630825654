// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/farm/plan_job.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::farm {
namespace {

constexpr int kLeastSamples = 4;       // Of a part.
constexpr double kLeastSeconds = 120;  // Of a part; shorter tasks mostly repeat the preparation.

constexpr double kMostStart = 0.05;  // Share of a process that loading may take.

/// Adds the tasks of one picture.
class PictureTasks {
 public:
  PictureTasks(const JobOptions& options, const std::string& stem, std::vector<std::string> common,
               Job& job)
      : options_(options), stem_(stem), common_(std::move(common)), job_(job) {}

  void add_whole() {
    const PictureCost& cost = options_.cost;
    Task task = new_task(stem_, stem_ + ".exr",
                         cost.build_seconds + cost.learn_seconds + cost.render_seconds);
    add(task.arguments, {"-o", task.makes});
    add_checkpoint(task);
    job_.pictures.push_back({task.makes, {}});
    job_.tasks.push_back(std::move(task));
  }

  /// `first_learned`: the task that learned the light of the first picture.
  void add_parts(std::optional<size_t> first_learned) {
    const PictureCost& cost = options_.cost;
    const size_t picture = job_.pictures.size(), learning = job_.tasks.size();
    Task learn = new_task(stem_ + ".learn", "parts/" + stem_ + ".learned",
                          cost.build_seconds + cost.learn_seconds);
    add(learn.arguments, {"--guiding", learn.makes});
    if (first_learned) learn.needs.push_back(*first_learned);
    const std::string learned = learn.makes;
    job_.pictures.push_back({stem_ + ".exr", {}});
    job_.tasks.push_back(std::move(learn));
    const auto parts = static_cast<uint32_t>(options_.parts);
    for (uint32_t part = 0; part < parts; ++part) {
      const std::string name = fmt::format("{}.part{:02}", stem_, part);
      Task task = new_task(name, "parts/" + name, cost.build_seconds + cost.render_seconds / parts);
      const auto sample = [&](uint32_t i) { return uint64_t{options_.spp} * i / parts; };
      add(task.arguments, {"--guiding", learned, "--part", task.makes, "--samples",
                           fmt::format("{}..{}", sample(part), sample(part + 1))});
      // The task that learns checks the scene.
      add(task.arguments, {"--anyway", "--untested"});
      add_checkpoint(task);
      task.needs = {learning};
      task.part_of = picture;
      job_.pictures[picture].parts.push_back(job_.tasks.size());
      job_.tasks.push_back(std::move(task));
    }
  }

 private:
  Task new_task(const std::string& name, const std::string& makes, double seconds) const {
    Task task;
    task.name = name;
    task.arguments = common_;
    task.makes = makes;
    task.seconds = std::round(seconds);
    task.bytes = std::round(options_.cost.bytes);
    return task;
  }

  static void add(std::vector<std::string>& arguments, const std::vector<std::string>& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
  }

  static void add_checkpoint(Task& task) {
    add(task.arguments, {"--checkpoint", "state/" + task.name + ".checkpoint", "--resume"});
  }

  const JobOptions& options_;
  std::string stem_;
  std::vector<std::string> common_;
  Job& job_;
};

}  // namespace

Job plan_job(const JobOptions& options) {
  if (options.parts < 1)
    throw Error(ErrorCode::bad_input, "a picture has at least one part", {}, "write --parts 8");
  if (static_cast<uint32_t>(options.parts) > options.spp)
    throw Error(
        ErrorCode::bad_input,
        fmt::format("{} parts are more than the {} samples per pixel", options.parts, options.spp),
        {}, "decrease --parts, or increase --spp");
  Job job;
  job.version = VUG_VERSION;
  job.inputs = options.inputs;
  std::vector<std::string> common{"render", options.scene};
  common.insert(common.end(), options.render_arguments.begin(), options.render_arguments.end());
  std::optional<size_t> first_learned;
  const auto add = [&](const std::string& stem, const std::vector<std::string>& arguments) {
    PictureTasks tasks(options, stem, arguments, job);
    if (options.parts == 1) return tasks.add_whole();
    const size_t learning = job.tasks.size();
    tasks.add_parts(first_learned);
    if (!first_learned) first_learned = learning;
  };
  if (options.frames.empty()) add(options.name, common);
  for (const int frame : options.frames) {
    std::vector<std::string> arguments = common;
    arguments.push_back(fmt::format("--frame={}", frame));
    add(fmt::format("{}.{:04}", options.name, frame), arguments);
  }
  return job;
}

int default_parts(const JobOptions& options, int cores) {
  const auto pictures = static_cast<double>(std::max<size_t>(1, options.frames.size()));
  const double wanted = std::ceil(cores / pictures);
  const double most = std::min(options.cost.render_seconds / kLeastSeconds,
                               static_cast<double>(options.spp) / kLeastSamples);
  return static_cast<int>(std::clamp(std::min(wanted, most), 1.0, 1e4));
}

int default_chunk(const JobOptions& options) {
  const double part = options.cost.render_seconds / options.parts;
  const double wanted = (1 / kMostStart - 1) * options.cost.start_seconds / std::max(part, 1e-9);
  return static_cast<int>(std::clamp(std::ceil(wanted), 1.0, 1.0 * options.parts));
}

}  // namespace vug::farm
