// SPDX-License-Identifier: Apache-2.0
// Divides pictures into tasks.
#pragma once

#include <vug/farm/estimate.h>
#include <vug/farm/job.h>

#include <cstdint>

namespace vug::farm {

struct JobOptions {
  std::string scene;                          ///< Absolute path.
  std::string name = "picture";               ///< Stem of the names of the pictures.
  std::vector<std::string> render_arguments;  ///< Arguments of `vug render` for every task.
  std::vector<int> frames;                    ///< Empty: one picture of a still scene.
  uint32_t spp = 1;                           ///< Samples per pixel.
  int parts = 1;  ///< Tasks per picture, each with a range of its samples; at most `spp`.
  PictureCost cost;
  std::vector<Input> inputs;
};

/// Each picture that is divided has a task that learns its light, then its parts. Later pictures
/// learn after the first one, so that products which frames share are made once. A picture of one
/// part is a single task. Error(bad_input) for parts < 1 or more parts than samples.
Job plan_job(const JobOptions& options);

/// The number of parts that gives a machine with `cores` cores work and leaves each task at least a
/// few minutes and four samples.
int default_parts(const JobOptions& options, int cores);

/// The number of parts of one picture that a process must run so that its start takes at most a
/// twentieth of its time; at most all of them.
int default_chunk(const JobOptions& options);

}  // namespace vug::farm
