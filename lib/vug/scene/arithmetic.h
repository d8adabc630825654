// SPDX-License-Identifier: Apache-2.0
// Arithmetic with dimensions.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/base/value.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::scene {

/// The location of an expression and the diagnostics to which its errors are added.
struct FaultSite {
  const SourceLocation& where;
  Diagnostics& diagnostics;

  /// Adds an error and returns the empty value, which suppresses errors of dependent expressions.
  Value fault(std::string message, std::string hint = {}) const {
    diagnostics.error(where, std::move(message), std::move(hint));
    return {};
  }
};

/// Gives both numbers the same dimension: a plain number takes the dimension of the other one; for
/// angles only 0 may be plain. Returns false after an error such as "`doing` a length and an
/// angle".
bool unify_dimensions(Number& a, Number& b, const std::string& doing, const FaultSite& site);

/// a op b for op in + - * / ^ on numbers and vectors: lengths add to lengths, a length multiplied
/// by a length is an area, 1 divided by a length is per metre. Results without a known dimension
/// are errors, as are division by zero and overflow. + joins a text with a text or a number.
/// Returns nothing for other types.
std::optional<Value> arithmetic(char op, const Value& a, const Value& b, const FaultSite& site);

/// -a or +a for numbers and vectors; nothing for other types.
std::optional<Value> negate(char op, const Value& a);

/// a op b for op in < <= > >= == !=. Numbers are ordered; all types except lists and objects
/// support equality. Returns nothing for other types.
std::optional<Value> compare(const std::string& op, const Value& a, const Value& b,
                             const FaultSite& site);

/// The vector (x, y, z) of three numbers, or the list [x, y] of two, all with the same dimension.
Value vector_of(std::vector<Number> parts, const FaultSite& site);

}  // namespace vug::scene
