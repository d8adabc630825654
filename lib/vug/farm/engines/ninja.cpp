// SPDX-License-Identifier: Apache-2.0
// https://ninja-build.org/manual.html
#include <vug/farm/engine_files.h>

#include <fmt/format.h>

namespace vug::farm {
namespace {

/// With the characters escaped that ninja interprets in paths.
std::string path_text(const std::string& path) {
  std::string out;
  for (const char c : path) {
    if (c == '$' || c == ' ' || c == ':') out += '$';
    out += c;
  }
  return out;
}

}  // namespace

EngineFile ninja_file(const Job& job, const EngineOptions& options) {
  std::string text = fmt::format(
      "# One machine, several processes: ninja -j 2. Run it again after an interruption.\n"
      "rule task\n"
      "  command = '{}' farm run . --task $id --threads {}\n"
      "  description = $name\n\n",
      options.program, options.cores);
  for (size_t i = 0; i < job.tasks.size(); ++i) {
    const Task& task = job.tasks[i];
    text += "build " + path_text(task.makes) + ": task";
    if (!task.needs.empty()) text += " ||";
    for (const size_t needed : task.needs) text += " " + path_text(job.tasks[needed].makes);
    text += fmt::format("\n  id = {}\n  name = {}\n", i, task.name);
  }
  return {"build.ninja", std::move(text), false, "ninja -j 2"};
}

}  // namespace vug::farm
