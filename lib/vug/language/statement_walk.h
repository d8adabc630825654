// SPDX-License-Identifier: Apache-2.0
// Walks through the expressions of a statement with the calls around each of them.
#pragma once

#include <vug/scene/document.h>

#include <functional>
#include <string>
#include <vector>

namespace vug::language {

/// An expression around another one, and the operand of it that leads there.
struct Enclosing {
  const scene::Expr* expr = nullptr;
  size_t operand = 0;
};
using EnclosingChain = std::vector<Enclosing>;  ///< From the outermost to the innermost.

/// Visits an expression, then its parts. `visit` returns whether the parts are visited, too.
void walk(const scene::Expr& expr, EnclosingChain& chain,
          const std::function<bool(const scene::Expr&, const EnclosingChain&)>& visit);

/// A declaration, a let, a function or a grammar.
struct Statement {
  const scene::Declaration* declaration = nullptr;
  const scene::Let* let = nullptr;
  const scene::Def* def = nullptr;
  const scene::Grammar* grammar = nullptr;

  bool known() const { return declaration || let || def || grammar; }
  const SourceLocation& extent() const;
};

/// The statement on a line of a file; unknown if there is none.
Statement statement_at(const scene::Document& document, const std::string& file, int line);

/// The first use of a let in a declaration or another let, with the expressions around it.
struct LetUse {
  Statement statement;  ///< Unknown: the let is not used there.
  EnclosingChain chain;
};
LetUse first_use(const scene::Document& document, const scene::Let& let);

}  // namespace vug::language
