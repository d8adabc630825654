// SPDX-License-Identifier: Apache-2.0
// The numbers of a statement that have a place in the scene, so that a drag in a picture can change
// them.
#pragma once

#include <vug/base/transform.h>
#include <vug/language/handle_role.h>
#include <vug/language/number_literal.h>

#include <string>
#include <vector>

namespace vug::language {

/// A point, a direction, or a length that is written with numbers.
struct LiteralHandle {
  std::string name;  ///< "center", "path[2]", "size.x": unique in the statement.
  HandleRole role = HandleRole::point;
  SourceLocation where;                ///< The whole value in the text.
  std::vector<NumberLiteral> numbers;  ///< Three of points and directions, one of lengths.
  Transform place;                     ///< From the space of the numbers to the scene.
  Vec3d anchor{0, 0, 0};  ///< Where directions and lengths begin, in the space of the numbers.
  Vec3d axis{1, 0,
             0};  ///< Unit vector of a length, whose knob is at anchor + axis * share * value.
  double share = 1;
  double least = -kInfinity;  ///< Smallest number.

  /// The numbers of a point or a direction.
  Vec3d vector() const { return {numbers[0].value, numbers[1].value, numbers[2].value}; }
  /// Its place in the scene; of a direction, the place of its anchor.
  Vec3d position() const;
};

/// A value that has a place but no handle.
struct MissingHandle {
  std::string name;
  SourceLocation where;
  std::string reason;  ///< The end of a sentence: "it is an expression".
};

struct StatementHandles {
  std::string title;  ///< "light lamp"; empty without a statement.
  SourceLocation extent;
  std::vector<LiteralHandle> handles;
  std::vector<MissingHandle> missing;

  /// Error(bad_input) with the reason or the nearest name.
  const LiteralHandle& find(const std::string& name) const;
};

/// The handles of the statement on a line of the text.
StatementHandles handles_at(const Analysis& analysis, int line);

/// The texts of other values of the numbers of a handle, in its notation, with errors below `step`.
/// A number that changes by less keeps its text.
std::vector<std::string> number_texts(const LiteralHandle& handle,
                                      const std::vector<double>& values, double step);

}  // namespace vug::language
