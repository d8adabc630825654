// What stands around a module of a word with branches (prusinkiewicz1990, section 1.8).
#pragma once

#include <vug/lsystem/system.h>

namespace vug::lsystem {

/// Looks around in one word. The word and the system must outlive it.
class ContextMatcher {
 public:
  /// Finds the way from each module to its neighbours, in one pass, if some rule looks around.
  ContextMatcher(const System& system, const Word& word, bool contexts);

  /// Whether both contexts of the production fit around module `i`; then its formals, those of the
  /// module itself included, are in `formals`, which must have room.
  /// - To the left the way leads to the root: past the branches that end on it, out of those that
  ///   begin on it.
  /// - To the right it leads on along the same branch, past side branches. "[" in the pattern
  ///   enters the first of the side branches here in which the pattern up to "]" fits.
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
  // By module, none of them where no rule looks around; nothing found is the word's size.
  UninitializedVector<uint32_t> partner_;  ///< Of brackets.
  UninitializedVector<uint32_t> left_;     ///< The first that is seen on the way to the root.
  UninitializedVector<uint32_t>
      right_;  ///< The first from here on that is seen on this branch, or its "]".
};

}  // namespace vug::lsystem
