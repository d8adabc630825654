// One synchronous step: every module of a word is replaced at once.
//
// Two passes over fixed chunks of the word, so that no result depends on the number of threads and
// nothing is copied twice: the first chooses a production for each module and counts what it will
// make, the second writes everything where it belongs.
//
// Random numbers are keyed by the way from the axiom: a module's key is its parent's key and its
// place in the successor (draws.h). So a branch keeps its numbers whatever happens in others.
#pragma once

#include <vug/lsystem/system.h>

namespace vug::lsystem {

/// A word with what its future depends on.
struct Derivation {
  Word word;
  UninitializedVector<uint64_t> keys;  ///< Of each module; empty in systems without chance.
  uint64_t key = 0;                    ///< Of all its random numbers.

  bool operator==(const Derivation&) const = default;
};

enum class RewriteMode {
  step,     ///< Where no production of a module fits, it stays, but draws anew in the next step.
  passing,  ///< Of a stage, or of time: a module that stays is the same as before.
};

/// Where a word was made by one call of `rewrite` after the other, its buffers are used again.
class Rewriter {
 public:
  /// `memory`: bytes that a word may take; without it, what the machine can give then.
  explicit Rewriter(const System& system, std::optional<uint64_t> memory = {})
      : system_(system), memory_(memory) {}

  /// The axiom's word, with the system's key or another.
  void start(Derivation& out, std::optional<uint64_t> key = {}) const;

  /// Replaces the modules of `word` by the book; false when no production fits anywhere. Cuts first
  /// where there is a "%". `salt` tells the draws of stages apart. Error(too_large) beyond the
  /// system's limit or what memory there is, Error(bad_input) where a parameter, a weight or an age
  /// is no finite number, both naming the production.
  bool rewrite(const RuleBook& book, Derivation& word, RewriteMode mode, uint32_t salt = 0);

  /// A production that the last call has applied; null where it was none.
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
  UninitializedVector<uint16_t> choice_;  ///< By module: production and 1, or 0 for none.
};

}  // namespace vug::lsystem
