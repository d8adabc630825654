// Arithmetic of numbers that know what they measure.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/base/value.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::scene {

/// Where to report, and to whom.
struct FaultSite {
  const SourceLocation& where;
  Diagnostics& diagnostics;

  /// Reports and gives the value that silences what uses it.
  Value fault(std::string message, std::string hint = {}) const {
    diagnostics.error(where, std::move(message), std::move(hint));
    return {};
  }
};

/// Makes both measure the same: a bare number takes the other's dimension, but beside an angle
/// only 0 may be bare. False after reporting "`doing` a length and an angle".
bool unify_dimensions(Number& a, Number& b, const std::string& doing, const FaultSite& site);

/// a op b for op in + - * / ^ on numbers and vectors: lengths add to lengths, a length by a
/// length is a plain number, 1 by a length is per metre; areas and the like have no meaning
/// here and are reported, as are division by zero and overflow. Nothing for other types.
std::optional<Value> arithmetic(char op, const Value& a, const Value& b, const FaultSite& site);

/// -a or +a; nothing for other types.
std::optional<Value> negate(char op, const Value& a);

/// a op b for op in < <= > >= == !=. Numbers compare by size, all but lists and objects by
/// equality. Nothing for other types.
std::optional<Value> compare(const std::string& op, const Value& a, const Value& b,
                             const FaultSite& site);

/// The dimension of a product (or, with power -1, of a quotient); nothing where none fits.
std::optional<Dimension> product(Dimension a, Dimension b, int power = 1);

/// (x, y, z) of three numbers, [x, y] of two, all of one dimension.
Value vector_of(std::vector<Number> parts, const FaultSite& site);

}  // namespace vug::scene
