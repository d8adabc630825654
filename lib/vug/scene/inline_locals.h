// SPDX-License-Identifier: Apache-2.0
// Names of `where` in the rules of facades and L-systems, which are replaced by their expressions
// before the rule is compiled. They cannot draw random numbers: a draw would have another value at
// each use.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/scene/document.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace vug::scene {

/// Replaces the names of one rule in its expressions. Loop variables hide them; a loop variable
/// that occurs in one of their expressions is renamed. Cyclic names, which `check_locals` reports,
/// are not replaced.
class LocalInliner {
 public:
  explicit LocalInliner(const std::vector<Let>& locals);

  /// The expression with its names replaced; null for null, and the same one if nothing changes.
  ExprPtr operator()(const ExprPtr& expr) const;

 private:
  using Substitution = std::map<std::string, ExprPtr>;  ///< Null: hidden.

  void resolve(const Let& local, const std::vector<Let>& all, std::set<std::string>& pending);
  ExprPtr replace(const ExprPtr& expr, const Substitution& hidden) const;

  Substitution values_;
  std::set<std::string> occurring_;  ///< All names in the expressions of the locals.
};

/// The functions of a document whose calls draw random numbers, directly or through others.
std::set<std::string> drawing_functions(const std::vector<Def>& defs);

/// Reports names of one rule that depend on themselves, draw random numbers, or whose replacement
/// in `uses`, the expressions of the rule, would exceed 100,000 operations or 1000 levels.
void check_locals(const std::vector<Let>& locals, const std::vector<ExprPtr>& uses,
                  const std::set<std::string>& drawing, Diagnostics& diagnostics);

}  // namespace vug::scene
