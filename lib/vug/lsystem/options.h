// What the block of an L-system may set beside its axiom and rules; the turtle's options are others
// (turtle.h).
#pragma once

#include <vug/base/schema.h>
#include <vug/scene/evaluator.h>

#include <optional>

namespace vug::lsystem {

struct SystemOptions {
  int steps = 1;
  double time = 0;             ///< Of systems whose modules age, in place of steps.
  double limit = 10e6;         ///< Modules of a word at most.
  std::optional<double> seed;  ///< In place of the scene's, a whole number.
};

/// Adds the parameters to the schema of a block that holds more than these.
template <std::derived_from<SystemOptions> Block>
void describe_system(Schema<Block>& schema) {
  schema
      .param("steps", &SystemOptions::steps,
             {.doc = "how often all modules are replaced", .min = 0, .max = 1e6})
      .param("time", &SystemOptions::time,
             {.doc = "in place of steps, where modules age", .min = 0, .max = 1e9})
      .param("limit", &SystemOptions::limit,
             {.doc = "modules of a word at most", .min = 1, .max = 4e9})
      .param("seed", &SystemOptions::seed,
             {.doc = "whole number in place of the scene's seed", .min = 0, .max = 0x1p53});
}

/// False, with diagnostics at their values, where limit or seed are no whole numbers.
bool check_whole(const SystemOptions& options, const scene::Grammar& grammar,
                 Diagnostics& diagnostics);

/// Those of a block's entries that are a system's; nothing, with diagnostics, where one does not
/// fit. Entries of other names are passed over.
std::optional<SystemOptions> system_options(const scene::Grammar& grammar,
                                            scene::Evaluator& evaluator);

}  // namespace vug::lsystem
