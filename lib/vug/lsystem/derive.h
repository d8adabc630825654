// SPDX-License-Identifier: Apache-2.0
// Derivation of a system to a word, by steps or by time, and its interpretation for the turtle.
#pragma once

#include <vug/base/progress.h>
#include <vug/lsystem/rewriting.h>

namespace vug::lsystem {

/// The environment of an open L-system: it answers queries. A query is a module in the word whose
/// parameters, as many as were written, are set by the environment:
///   ?P(x, y, z)     the turtle's position, metres
///   ?H(x, y, z)     its heading; ?L and ?U: its left and up vectors (unit vectors)
///   ?D(d, x, y, z)  the signed distance to the system's field, metres, negative inside, and the
///                   field's gradient
class Environment {
 public:
  virtual ~Environment() = default;
  /// Sets the parameters of the queries in `drawn`, the interpreted word as read by the turtle,
  /// with all queries in order, and changes nothing else. Called after the axiom and after each
  /// step.
  virtual void answer(const System& system, Word& drawn) const = 0;
};

struct DeriveOptions {
  std::optional<int> steps = {};             ///< Overrides the system's steps.
  std::optional<double> time = {};           ///< Overrides the time of a system whose modules age.
  std::optional<uint64_t> key = {};          ///< Overrides the system's random key.
  std::optional<uint64_t> memory = {};       ///< Bytes per word; default: the available memory.
  const Environment* environment = nullptr;  ///< Null: queries keep their written parameters.
};

/// The word after the system's steps, or at its time.
/// - A step applies the scheduled rule book and then the decomposition. The axiom is decomposed,
/// too.
/// - In a system whose modules age, a module is replaced when its age reaches the `after` of its
/// rule,
///   and the ages of its successors are increased by the remaining time. Ages are continuous in
///   time, and random choices do not change as time proceeds.
/// The word is the same for any number of threads. Throws the errors of Rewriter::rewrite.
Derivation derive(const System& system, const DeriveOptions& options = {},
                  Progress& progress = Progress::none());

/// The word as drawn by the turtle: applies the interpretation rules and replaces modules that
/// refer to other systems by their words. `memory` is as in DeriveOptions.
Word interpret(const System& system, Derivation derivation, Progress& progress = Progress::none(),
               std::optional<uint64_t> memory = {});

}  // namespace vug::lsystem
