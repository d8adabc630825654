// SPDX-License-Identifier: Apache-2.0
#include <vug/farm/engine_files.h>

#include <algorithm>

namespace vug::farm {

std::vector<EngineFile> engine_files(const Job& job, const EngineOptions& options) {
  return {ninja_file(job, options), parallel_file(job, options), slurm_file(job, options),
          openjd_file(job, options)};
}

std::vector<std::vector<std::pair<size_t, size_t>>> levels(const Job& job) {
  std::vector<size_t> level_of(job.tasks.size(), 0);
  std::vector<std::vector<std::pair<size_t, size_t>>> out;
  for (size_t i = 0; i < job.tasks.size(); ++i) {
    for (const size_t needed : job.tasks[i].needs)
      level_of[i] = std::max(level_of[i], level_of[needed] + 1);
    if (out.size() <= level_of[i]) out.resize(level_of[i] + 1);
    auto& ranges = out[level_of[i]];
    if (!ranges.empty() && ranges.back().second + 1 == i)
      ranges.back().second = i;
    else
      ranges.emplace_back(i, i);
  }
  return out;
}

std::vector<std::vector<ChunkedRange>> chunked_levels(const Job& job, size_t chunk) {
  std::vector<std::vector<ChunkedRange>> out;
  for (const auto& ranges : levels(job)) {
    auto& level = out.emplace_back();
    for (const auto& [first, last] : ranges)
      for (size_t i = first; i <= last; ++i) {
        const std::optional<size_t>& picture = job.tasks[i].part_of;
        const bool joins =
            i > first && (chunk <= 1 || picture == job.tasks[level.back().last].part_of);
        if (joins)
          level.back().last = i;
        else
          level.push_back({i, i, picture ? std::max<size_t>(1, chunk) : 1});
      }
  }
  return out;
}

}  // namespace vug::farm
