// SPDX-License-Identifier: Apache-2.0
// Files with which other programs run a job.
#pragma once

#include <vug/farm/job.h>

#include <string>
#include <vector>

namespace vug::farm {

/// A file in the folder of the job.
struct EngineFile {
  std::string name;  ///< "build.ninja"
  std::string text;
  bool executable = false;
  std::string command;  ///< That starts the job, for people; run in the folder of the job.
};

/// The program that the engines run, and the cores of a task.
struct EngineOptions {
  std::string program = "vug";
  int cores = 1;
  size_t chunk = 1;  ///< Parts of one picture that share a process.
};

EngineFile ninja_file(const Job& job, const EngineOptions& options);
/// For GNU parallel.
EngineFile parallel_file(const Job& job, const EngineOptions& options);
EngineFile slurm_file(const Job& job, const EngineOptions& options);
/// A template of Open Job Description, 2023-09.
EngineFile openjd_file(const Job& job, const EngineOptions& options);

/// All of them.
std::vector<EngineFile> engine_files(const Job& job, const EngineOptions& options);

/// Tasks first to last, of which each `chunk` are one call of `vug farm run`; the last call may
/// have fewer.
struct ChunkedRange {
  size_t first = 0, last = 0, chunk = 1;
  bool operator==(const ChunkedRange&) const = default;
};

/// The levels of the job, whose ranges are divided so that each chunk contains parts of one picture
/// or a single task.
std::vector<std::vector<ChunkedRange>> chunked_levels(const Job& job, size_t chunk);

/// The tasks in the order in which arrays of tasks can run one after the other: those of each level
/// only need tasks of lower ones. Each level is a list of ranges [first, last] of task numbers.
std::vector<std::vector<std::pair<size_t, size_t>>> levels(const Job& job);

}  // namespace vug::farm
