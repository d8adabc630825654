// SPDX-License-Identifier: Apache-2.0
// Visits all expressions and entries of a document.
#pragma once

#include <vug/scene/document.h>

#include <functional>

namespace vug::language {

/// Calls the functions that are set, an expression before its parts. Keys of the include of a
/// module are not entries of a document.
struct SyntaxVisitor {
  std::function<void(const scene::Expr&)> expression = {};
  std::function<void(const scene::Entry&)> entry = {};

  void visit(const scene::Document& document) const;
  void visit(const scene::ExprPtr& expr) const;

 private:
  void visit(const std::vector<scene::Entry>& entries) const;
  void visit(const std::vector<scene::Let>& lets) const;
  void visit(const std::vector<scene::Item>& items) const;
  void visit(const scene::Grammar& grammar) const;
};

/// The innermost call around a position of the document's first file; null if there is none.
const scene::Expr* call_around(const scene::Document& document, const SourceLocation& at);

}  // namespace vug::language
