// SPDX-License-Identifier: Apache-2.0
// The pictures of a scene, divided into tasks that several processes or machines can run, and the
// file of such a job.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vug::farm {

/// A file that the tasks read. They refuse to run if it changed after the job was planned.
struct Input {
  std::string file;    ///< Absolute path.
  std::string digest;  ///< The digest of its content, in hexadecimal digits.
  bool operator==(const Input&) const = default;
};

/// A call of `vug` that makes one file. Tasks with the same inputs make the same bytes, so that a
/// task may run again, or twice at the same time. All paths are relative to the folder of the job.
struct Task {
  std::string name;                    ///< Unique, for people: "frame0012.part03".
  std::vector<std::string> arguments;  ///< Arguments of the program, without its name.
  std::string makes;                   ///< The file, complete or absent.
  std::vector<size_t> needs;           ///< Earlier tasks whose files it reads.
  std::optional<size_t> part_of;       ///< The picture whose part it makes; none: another product.
  double seconds = 0;                  ///< Estimated duration on one machine of this kind.
  double bytes = 0;                    ///< Estimated memory.
  bool operator==(const Task&) const = default;
};

/// A picture that the last of its tasks merges from the files of all of them.
struct Picture {
  std::string file;           ///< The EXR, relative to the folder of the job.
  std::vector<size_t> parts;  ///< Tasks. Empty: a single task makes the picture itself.
  bool operator==(const Picture&) const = default;
};

struct Job {
  std::string version;  ///< The version that planned it; another one may make other bytes.
  std::vector<Input> inputs;
  std::vector<Picture> pictures;
  std::vector<Task> tasks;  ///< Each after those that it needs.
  bool operator==(const Job&) const = default;
};

/// Name of the file in the folder of the job.
inline constexpr const char* kJobFile = "job.json";

/// The same text for equal jobs.
std::string to_json(const Job& job);
/// Error(bad_input) with the file and the fault: missing, no job, or tasks and pictures that do not
/// exist.
Job read_job(const std::filesystem::path& folder);

/// Error(bad_input) if this is another version of the program, or if an input is missing or has
/// changed.
void require_inputs(const Job& job);

}  // namespace vug::farm
