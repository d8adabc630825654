// Expressions of a scene as a tree: immutable, shared, knowing where they stand in the text.
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
  broken   ///< Could not be understood; its fault has been told, and it has no value.
};

struct Expr;
using ExprPtr = std::shared_ptr<const Expr>;

/// A part of an expression; `name` is set for arguments given by name.
struct Operand {
  std::string name;
  SourceLocation where;  ///< Of the name if there is one, else of the value.
  ExprPtr value;
};

struct Expr {
  ExprKind kind = ExprKind::number;
  SourceLocation where;  ///< Operators: of their sign; calls: of the function's name.
  Number number;
  std::string text;
  std::vector<Operand> operands;
  /// Calls: written as receiver.f(...); the receiver is the first operand.
  bool method = false;
  /// Ranges and calls: identity inside the statement for seeded choice. It depends on the names
  /// of the enclosing calls and arguments and on how many equal paths stand before it, so that
  /// siblings of other names may come and go without changing what this one draws.
  uint64_t path = 0;
  /// Height of the tree below and with this node; the parser bounds it.
  int depth = 1;
};

/// One canonical line for the expression, fully parenthesised; equal trees (places aside) give
/// equal lines.
std::string dump(const Expr& expr);

}  // namespace vug::scene
