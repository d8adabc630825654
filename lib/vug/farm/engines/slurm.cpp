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
      "submit() {{  # FIRST LAST CHUNK MEGABYTES AFTER OPTIONS...\n"
      "  first=$1 last=$2 chunk=$3 memory=$4 after=$5\n"
      "  shift 5\n"
      "  sbatch --parsable --requeue --open-mode=append --cpus-per-task={0} --mem=\"${{memory}}M\" "
      "\\\n"
      "    --array=0-$(((last - first) / chunk)) --job-name=vug --output=state/slurm-%A_%a.log \\\n"
      "    ${{after:+--dependency=afterany:$after}} \"$@\" --wrap \"\n"
      "    begin=\\$(($first + $chunk * SLURM_ARRAY_TASK_ID))\n"
      "    end=\\$((begin + $chunk - 1))\n"
      "    exec '{1}' farm run . --threads {0} --tasks \\$begin-\\$((end < $last ? end : "
      "$last))\"\n"
      "}}\n"
      "after=\n",
      options.cores, options.program);
  for (const auto& ranges : chunked_levels(job, options.chunk)) {
    text += "level=\n";
    for (const auto& [begin, end, chunk] : ranges)
      for (size_t first = begin; first <= end; first += kArray * chunk) {
        const size_t last = std::min(end, first + kArray * chunk - 1);
        text += fmt::format(
            "id=$(submit {} {} {} {:.0f} \"$after\" \"$@\") || exit\n"
            "level=${{level:+$level:}}${{id%%;*}}\n",
            first, last, chunk, memory_of(job, first, last));
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
