// From a system to a word: steps or time, and what the turtle is given to read.
#pragma once

#include <vug/base/progress.h>
#include <vug/lsystem/rewriting.h>

namespace vug::lsystem {

/// What a word grows in: it answers the queries. Queries are modules that rules place and whose
/// parameters it sets, as many as they were written with:
///   ?P(x, y, z)     the turtle's position there, metres
///   ?H(x, y, z)     its heading, ?L and ?U its left and up: unit vectors
///   ?D(d, x, y, z)  the signed distance to the system's field, metres, negative inside, and the
///                   field's gradient
class Environment {
 public:
  virtual ~Environment() = default;
  /// `drawn` is the word as the turtle reads it: interpreted, with all queries in their order. Sets
  /// their parameters and nothing else. Called after the axiom and after each step.
  virtual void answer(const System& system, Word& drawn) const = 0;
};

struct DeriveOptions {
  std::optional<int> steps = {};             ///< Instead of the system's.
  std::optional<double> time = {};           ///< Likewise, of a system whose modules age.
  std::optional<uint64_t> key = {};          ///< Of its random numbers, instead of the system's.
  std::optional<uint64_t> memory = {};       ///< Bytes of a word, else what the machine can give.
  const Environment* environment = nullptr;  ///< Null: queries keep what they were written with.
};

/// The word after the system's steps, or at its time.
/// - A step takes the book whose turn it is, then decomposes what came out; so is the axiom.
/// - In a system whose modules age, those whose age reaches the `after` of their rule are replaced
///   at that moment, and their successors are by the rest of the time older than they were written.
///   Ages are continuous in time, and all random choices stay as time goes on.
/// Same word for any number of threads. Errors are those of Rewriter::rewrite.
Derivation derive(const System& system, const DeriveOptions& options = {},
                  Progress& progress = Progress::none());

/// The word as it is drawn: interpretation rules applied, modules that stand for other systems
/// replaced by their words. `memory` as DeriveOptions::memory.
Word interpret(const System& system, Derivation derivation, Progress& progress = Progress::none(),
               std::optional<uint64_t> memory = {});

}  // namespace vug::lsystem
