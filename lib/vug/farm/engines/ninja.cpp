// SPDX-License-Identifier: Apache-2.0
// https://ninja-build.org/manual.html
#include <vug/farm/engine_files.h>

#include <fmt/format.h>

#include <algorithm>

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

/// The products of other tasks that must exist before.
std::string needed_text(const Job& job, const Task& task) {
  std::string text = task.needs.empty() ? "" : " ||";
  for (const size_t needed : task.needs) text += " " + path_text(job.tasks[needed].makes);
  return text;
}

std::string task_edge(const Job& job, size_t task) {
  const Task& each = job.tasks[task];
  return fmt::format("build {}: task{}\n  id = {}\n  name = {}\n", path_text(each.makes),
                     needed_text(job, each), task, each.name);
}

/// Parts of one picture need the same tasks.
std::string chunk_edge(const Job& job, size_t first, size_t last) {
  return fmt::format("build chunk.{0}-{1}: chunk{2}\n  ids = {0}-{1}\n  name = {3} to {4}\n", first,
                     last, needed_text(job, job.tasks[first]), job.tasks[first].name,
                     job.tasks[last].name);
}

}  // namespace

EngineFile ninja_file(const Job& job, const EngineOptions& options) {
  std::string text = fmt::format(
      "# One machine, several processes: ninja -j 2. Run it again after an interruption.\n"
      "rule task\n"
      "  command = '{}' farm run . --task $id --threads {}\n"
      "  description = $name\n\n",
      options.program, options.cores);
  if (options.chunk > 1)
    text += fmt::format(
        "# A chunk does not name its files, because ninja removes those of a command that is\n"
        "# interrupted. It always runs, and ends at once if all its tasks are done.\n"
        "rule chunk\n"
        "  command = '{}' farm run . --tasks $ids --threads {}\n"
        "  description = $name\n\n",
        options.program, options.cores);
  for (const auto& level : chunked_levels(job, options.chunk))
    for (const ChunkedRange& range : level)
      for (size_t i = range.first; i <= range.last; i += range.chunk) {
        const size_t last = std::min(range.last, i + range.chunk - 1);
        text += i == last ? task_edge(job, i) : chunk_edge(job, i, last);
      }
  return {"build.ninja", std::move(text), false, "ninja -j 2"};
}

}  // namespace vug::farm
