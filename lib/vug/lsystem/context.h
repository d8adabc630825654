// SPDX-License-Identifier: Apache-2.0
// Context matching in words with branches (prusinkiewicz1990, section 1.8).
#pragma once

#include <vug/lsystem/system.h>

namespace vug::lsystem {

/// Matches the contexts of productions in one word. The word and the system must outlive it.
class ContextMatcher {
 public:
  /// Precomputes the neighbours of all modules in one pass, if some rule has a context.
  ContextMatcher(const System& system, const Word& word, bool contexts);

  /// Whether both contexts of the production match at module `i`. If so, `formals` contains the
  /// values of its formals, including those of the module itself; it must have sufficient capacity.
  /// - The left context follows the path to the root: it skips side branches and leaves the
  /// branches
  ///   that contain the module.
  /// - The right context follows the same branch and skips side branches. "[" in the pattern enters
  ///   the first side branch at this position in which the pattern up to "]" matches.
  bool match(const Production& production, size_t i, double* formals) const;

 private:
  bool left(const Production& production, size_t i, double*& formals) const;
  bool right(const std::vector<ContextModule>& pattern, size_t from, size_t to, size_t at,
             double*& formals) const;
  bool ignored(size_t i) const { return system_.ignored[word_.symbol(i)]; }
  bool opens(size_t i) const { return system_.open == word_.symbol(i); }
  bool closes(size_t i) const { return system_.close == word_.symbol(i); }
  double* put(size_t i, double* formals) const;

  const System& system_;
  const Word& word_;
  // Indexed by module; empty if no rule has a context. The word's size means "not found".
  UninitializedVector<uint32_t> partner_;  ///< The matching bracket.
  UninitializedVector<uint32_t> left_;     ///< The nearest visible module towards the root.
  /// The first visible module from here on within this branch, or its "]".
  UninitializedVector<uint32_t> right_;
};

}  // namespace vug::lsystem
