// SPDX-License-Identifier: Apache-2.0
// Options of an L-system's block (steps, time, limit, seed), in addition to its axiom and rules;
// those of the turtle (step length, angle, width) are in turtle.h.
#pragma once

#include <vug/base/schema.h>
#include <vug/scene/evaluator.h>

#include <optional>

namespace vug::lsystem {

struct SystemOptions {
  int steps = 1;
  double time = 0;             ///< Replaces the steps of systems whose modules age.
  double limit = 10e6;         ///< Maximum number of modules of a word.
  std::optional<double> seed;  ///< Overrides the scene's seed; a whole number.
};

/// Adds these parameters to the schema of a block that has further ones.
template <std::derived_from<SystemOptions> Block>
void describe_system(Schema<Block>& schema) {
  schema
      .param("steps", &SystemOptions::steps,
             {.doc = "number of derivation steps", .min = 0, .max = 1e6})
      .param("time", &SystemOptions::time,
             {.doc = "replaces the steps if modules age", .min = 0, .max = 1e9})
      .param("limit", &SystemOptions::limit,
             {.doc = "maximum number of modules of a word", .min = 1, .max = 4e9})
      .param("seed", &SystemOptions::seed,
             {.doc = "overrides the scene's seed; a whole number", .min = 0, .max = 0x1p53});
}

/// Returns false, with diagnostics at the values, if limit or seed is not a whole number.
bool check_whole(const SystemOptions& options, const scene::Grammar& grammar,
                 Diagnostics& diagnostics);

/// The system options among a block's entries; nothing, with diagnostics, if one is invalid. Other
/// entries are ignored.
std::optional<SystemOptions> system_options(const scene::Grammar& grammar,
                                            scene::Evaluator& evaluator);

}  // namespace vug::lsystem
