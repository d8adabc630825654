// SPDX-License-Identifier: Apache-2.0
// Numbers as a text writes them, and other values in the same notation.
#pragma once

#include <vug/language/workspace.h>

#include <optional>
#include <string>

namespace vug::language {

/// A number with its sign and unit, such as "-1.5m".
struct NumberLiteral {
  SourceLocation where;
  std::string text;
  double value = 0;  ///< In the internal unit of its dimension.
};

/// The expression as a number; nothing for other expressions, and outside of the text.
std::optional<NumberLiteral> number_literal(const Analysis& analysis, const scene::Expr& expr);

/// The decimals that an error below `step`, which is positive, needs; at most nine.
int decimals_for(double step);

/// The number with that many decimals at most, without zeros at its end; never "-0".
std::string decimal_text(double value, int decimals, int least = 0);

/// The text of another value in the unit of `before`, or in `unit` if that has none, such as "m".
/// It has at least the decimals of `before`, and as many as an error below `step` needs.
std::string number_text(const std::string& before, double value, double step,
                        const std::string& unit = "");

}  // namespace vug::language
