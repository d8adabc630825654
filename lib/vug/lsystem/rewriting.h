// SPDX-License-Identifier: Apache-2.0
// One parallel rewriting step: all modules of a word are replaced at once.
//
// The step makes two passes over fixed chunks of the word, so that the result does not depend on
// the number of threads and nothing is copied twice: the first pass selects a production for each
// module and counts its output, the second one writes the output to its final position.
//
// Random numbers are keyed by the path from the axiom: a module's key is derived from its parent's
// key and its position in the successor (random_numbers.h), so a branch does not depend on others.
#pragma once

#include <vug/lsystem/system.h>

namespace vug::lsystem {

/// A word with the keys on which its further derivation depends.
struct Derivation {
  Word word;
  UninitializedVector<uint64_t> keys;  ///< Key of each module; empty in deterministic systems.
  uint64_t key = 0;                    ///< Key of all its random numbers.

  bool operator==(const Derivation&) const = default;
};

enum class RewriteMode {
  step,     ///< A module without an applicable production is kept with a new key for the next step.
  passing,  ///< For stages and ageing: a module that is kept also keeps its key.
};

/// Reuses its buffers when `rewrite` is called repeatedly for a word.
class Rewriter {
 public:
  /// `memory`: maximum bytes of a word; default: the memory available at that time.
  explicit Rewriter(const System& system, std::optional<uint64_t> memory = {})
      : system_(system), memory_(memory) {}

  /// Sets `out` to the axiom, with the system's key or another one.
  void start(Derivation& out, std::optional<uint64_t> key = {}) const;

  /// Replaces the modules of `word` by the rules of the book, after cutting branches at "%".
  /// Returns false if the mode is `passing` and no production applies. `salt` distinguishes the
  /// random numbers of stages. Throws Error(too_large) beyond the system's limit or the memory, and
  /// Error(bad_input) if a parameter, a weight or an age is not a finite number; both name the
  /// production.
  bool rewrite(const RuleBook& book, Derivation& word, RewriteMode mode, uint32_t salt = 0);

  /// A production that the last call applied; null if there was none.
  const Production* applied() const;

 private:
  struct Chunk;
  void choose(const RuleBook& book, const class ContextMatcher& around, Chunk& chunk,
              uint32_t salt);
  void write(const RuleBook& book, const class ContextMatcher& around, const Chunk& chunk,
             RewriteMode mode, uint32_t salt);
  void require_capacity(size_t modules, size_t values) const;
  [[noreturn]] void refuse(const std::string& what, bool by_values) const;

  const System& system_;
  std::optional<uint64_t> memory_;
  const Derivation* from_ = nullptr;
  Derivation to_;
  UninitializedVector<uint16_t> choice_;  ///< By module: index of the production + 1, 0 for none.
};

}  // namespace vug::lsystem
