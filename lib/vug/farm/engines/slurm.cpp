// SPDX-License-Identifier: Apache-2.0
// https://slurm.schedmd.com/sbatch.html
#include <vug/farm/engine_files.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::farm {
namespace {

// MaxArraySize is 1001 by default, and the largest index one less.
constexpr size_t kArray = 1000;
// For estimates that are too low.
constexpr double kMemoryMargin = 1.5;
constexpr double kMegabyte = 1024.0 * 1024.0;

double memory_of(const Job& job, size_t first, size_t last) {
  double bytes = 0;
  for (size_t i = first; i <= last; ++i) bytes = std::max(bytes, job.tasks[i].bytes);
  return std::ceil(kMemoryMargin * bytes / kMegabyte);
}

}  // namespace

EngineFile slurm_file(const Job& job, const EngineOptions& options) {
  // `afterany`, because a task whose dependency ended with `afterok` and failed once would never
  // run, not even after the dependency was requeued. A task whose inputs are missing ends with 3.
  std::string text = fmt::format(
      "#!/bin/sh\n"
      "# Submits the job to Slurm: ./slurm.sh [options of sbatch], e.g. ./slurm.sh -p render.\n"
      "# A last job runs again what was lost. Submit it again after an interruption.\n"
      "cd \"$(dirname \"$0\")\" || exit 3\n"
      "mkdir -p state\n"
      "submit() {{  # FIRST COUNT MEGABYTES AFTER OPTIONS...\n"
      "  first=$1 count=$2 memory=$3 after=$4\n"
      "  shift 4\n"
      "  sbatch --parsable --requeue --open-mode=append --cpus-per-task={0} --mem=\"${{memory}}M\" "
      "\\\n"
      "    --array=0-$((count - 1)) --job-name=vug --output=state/slurm-%A_%a.log \\\n"
      "    ${{after:+--dependency=afterany:$after}} \"$@\" --wrap \"exec '{1}' farm run . \\\n"
      "    --threads {0} --task \\$(($first + SLURM_ARRAY_TASK_ID))\"\n"
      "}}\n"
      "after=\n",
      options.cores, options.program);
  for (const auto& ranges : levels(job)) {
    text += "level=\n";
    for (const auto& [begin, last] : ranges)
      for (size_t first = begin; first <= last; first += kArray) {
        const size_t count = std::min(kArray, last - first + 1);
        text += fmt::format(
            "id=$(submit {} {} {:.0f} \"$after\" \"$@\") || exit\n"
            "level=${{level:+$level:}}${{id%%;*}}\n",
            first, count, memory_of(job, first, first + count - 1));
      }
    text += "after=$level\n";
  }
  const double memory = job.tasks.empty() ? 0 : memory_of(job, 0, job.tasks.size() - 1);
  text += fmt::format(
      "sbatch --requeue --cpus-per-task={0} --mem={2:.0f}M --job-name=vug-rest \\\n"
      "  --output=state/slurm-rest.log --dependency=\"afterany:$after\" \"$@\" \\\n"
      "  --wrap \"exec '{1}' farm run . --threads {0}\"\n",
      options.cores, options.program, memory);
  return {"slurm.sh", std::move(text), true, "./slurm.sh"};
}

}  // namespace vug::farm
