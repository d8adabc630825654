// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/farm/job_folder.h>
#include <vug/render/film/partial_render.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <system_error>

namespace vug::farm {
namespace {

namespace fs = std::filesystem;

constexpr std::array kEndings{Ending::done, Ending::stopped, Ending::failed, Ending::killed,
                              Ending::unusable};

bool is_file(const fs::path& path) {
  std::error_code fault;
  return fs::is_regular_file(path, fault);
}

}  // namespace

const char* name_of(TaskState state) {
  switch (state) {
    case TaskState::waiting:
      return "waiting";
    case TaskState::ready:
      return "ready";
    case TaskState::running:
      return "running";
    case TaskState::done:
      return "done";
    case TaskState::failed:
      break;
  }
  return "failed";
}

const char* name_of(Ending ending) {
  switch (ending) {
    case Ending::done:
      return "done";
    case Ending::stopped:
      return "stopped";
    case Ending::failed:
      return "failed";
    case Ending::killed:
      return "killed";
    case Ending::unusable:
      break;
  }
  return "unusable";
}

bool is_alive(const fs::path& claim) {
  std::error_code fault;
  const auto beat = fs::last_write_time(claim, fault);
  return !fault && fs::file_time_type::clock::now() - beat < kDeadAfter;
}

JobFolder::JobFolder(fs::path folder) : folder_(std::move(folder)), job_(read_job(folder_)) {}

fs::path JobFolder::state_file(const Task& task, const std::string& ending) const {
  return folder_ / "state" / (task.name + "." + ending);
}

bool JobFolder::made(const Task& task) const { return is_file(file(task.makes)); }

bool JobFolder::finished(const Picture& picture) const { return is_file(file(picture.file)); }

bool JobFolder::complete(const Picture& picture) const {
  return std::all_of(picture.parts.begin(), picture.parts.end(),
                     [&](size_t part) { return made(job_.tasks[part]); });
}

bool JobFolder::finished() const {
  return std::all_of(job_.pictures.begin(), job_.pictures.end(),
                     [&](const Picture& picture) { return finished(picture); });
}

TaskState JobFolder::state(size_t index) const {
  const Task& task = job_.tasks.at(index);
  // Parts may be removed once their picture is finished.
  const bool needless = task.part_of && finished(job_.pictures[*task.part_of]);
  const bool runs_now = is_alive(state_file(task, "claim"));
  if (needless || (made(task) && !runs_now)) return TaskState::done;
  if (runs_now) return TaskState::running;
  int failures = 0;
  for (const Run& run : runs(task)) {
    if (run.ending == Ending::unusable) return TaskState::failed;
    failures += run.ending == Ending::failed || run.ending == Ending::killed;
  }
  if (failures >= kMostFailures) return TaskState::failed;
  const bool ready = std::all_of(task.needs.begin(), task.needs.end(),
                                 [&](size_t needed) { return made(job_.tasks[needed]); });
  return ready ? TaskState::ready : TaskState::waiting;
}

std::vector<Run> JobFolder::runs(const Task& task) const {
  std::vector<Run> all;
  std::ifstream file(state_file(task, "runs"));
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string ending;
    Run run;
    if (!(words >> ending >> run.seconds)) continue;  // cut short by a full disk
    std::getline(words >> std::ws, run.where);
    const auto known = std::find_if(kEndings.begin(), kEndings.end(),
                                    [&](Ending each) { return ending == name_of(each); });
    if (known != kEndings.end()) run.ending = *known;
    all.push_back(std::move(run));
  }
  return all;
}

void JobFolder::add_run(const Task& task, const Run& run) const {
  const fs::path path = state_file(task, "runs");
  std::error_code fault;
  fs::create_directories(path.parent_path(), fault);
  // One short write at the end of the file, which does not mix with those of other processes.
  std::ofstream file(path, std::ios::app);
  file << fmt::format("{} {:.1f} {}\n", name_of(run.ending), run.seconds, run.where);
  if (!file.flush())
    throw Error(ErrorCode::io, fmt::format("cannot write '{}'", path.string()), {},
                "check the free space and the permissions of the job's folder");
}

std::vector<std::string> JobFolder::remove_damaged_parts(const Picture& picture) const {
  std::vector<std::string> removed;
  for (const size_t part : picture.parts) {
    const Task& task = job_.tasks[part];
    try {
      render::verify_partial_render(file(task.makes));
    } catch (const Error& error) {
      if (error.code() != ErrorCode::bad_input) throw;
      std::error_code fault;
      fs::remove(file(task.makes), fault);
      removed.push_back(task.makes);
    }
  }
  return removed;
}

}  // namespace vug::farm
