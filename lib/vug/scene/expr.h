// SPDX-License-Identifier: Apache-2.0
// Expression trees of a scene: immutable, shared, with the ranges of their text.
#pragma once

#include <vug/base/error.h>
#include <vug/base/value.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace vug::scene {

enum class ExprKind {
  number,  ///< `number`
  text,    ///< `text`, unescaped
  truth,   ///< `text` is "true" or "false"
  name,    ///< `text`: a parameter, a let, a declaration or an enumerator
  vector,  ///< 2 or 3 operands: (x, y) or (x, y, z)
  list,    ///< any number of operands; 1920x1080 is the list [1920, 1080]
  unary,   ///< `text` is "-", "+" or "not"; 1 operand
  binary,  ///< `text` is + - & * / ^ < <= > >= == != and or; 2 operands
  range,   ///< lo..hi, a uniform random draw; 2 operands
  call,    ///< `text` is the function; operands are its arguments
  index,   ///< list[index]; 2 operands
  /// [for ... : value]: the clauses in the order of the text, then the value.
  comprehension,
  broken  ///< Has a reported syntax error and no value.
};

struct Expr;
using ExprPtr = std::shared_ptr<const Expr>;

/// A name that a function, a rule or a loop binds.
struct Formal {
  std::string name;
  SourceLocation where;
  ExprPtr fallback = nullptr;  ///< The default of a function's parameter; null: required.
  std::string doc = {};        ///< Parameters of functions only.
};

/// An operand or argument of an expression; `name` is set for arguments given by name.
struct Operand {
  std::string name;      ///< In a comprehension: "for", "if" or "sort"; the value has none.
  SourceLocation where;  ///< From the name, if any, to the end of the value.
  ExprPtr value;
  /// The names that a "for" binds to each element; two or more take a list apart. They are visible
  /// in the operands after this one.
  std::vector<Formal> binds = {};
};

struct Expr {
  ExprKind kind = ExprKind::number;
  SourceLocation extent;  ///< The whole expression, without brackets around it.
  SourceLocation where;   ///< For messages: the extent; of a method call only from its name on.
  Number number;
  std::string text;
  /// Names and calls in a file that was included `as NAME`: the prefix of the names that this file
  /// declares, such as "rocks."; null in other files.
  std::shared_ptr<const std::string> module;
  std::vector<Operand> operands;
  /// Calls: true if written as receiver.f(...); the receiver is the first operand.
  bool method = false;
  /// Ranges, calls and comprehensions: identity within the statement for seeded random choices. It
  /// depends on the names of the enclosing calls and arguments and on the number of equal paths
  /// before it, so that siblings with other names can be added or removed without changing its
  /// random numbers.
  uint64_t path = 0;
  /// Height of the tree including this node; the parser limits it.
  int depth = 1;
};

/// The name under which a declaration in the file of this expression is known: with the prefix of
/// its module.
inline std::string full_name(const Expr& expr) {
  return expr.module ? *expr.module + expr.text : expr.text;
}

/// The location of a word that `where` starts with, such as the name of a call.
SourceLocation word_at(const SourceLocation& where, const std::string& word);

/// The expression in one canonical line, fully parenthesised; trees that are equal except for
/// locations have equal lines.
std::string dump(const Expr& expr);

}  // namespace vug::scene
