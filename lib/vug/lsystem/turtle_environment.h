// SPDX-License-Identifier: Apache-2.0
// An environment that answers the queries of a word from the turtle's pose and a field.
#pragma once

#include <vug/field/field.h>
#include <vug/lsystem/derive.h>
#include <vug/lsystem/turtle.h>

#include <optional>
#include <vector>

namespace vug::lsystem {

struct TurtleQuery {
  const char* name;
  const char* doc;
};
const std::vector<TurtleQuery>& turtle_queries();

class TurtleEnvironment final : public Environment {
 public:
  /// Without a field, ?D returns free space: a distance of 1e6 m and a zero gradient.
  explicit TurtleEnvironment(TurtleOptions options, std::optional<field::Field> field = {})
      : options_(std::move(options)), field_(std::move(field)) {}

  /// Answers ?P, ?H, ?L, ?U and ?D as documented in Environment; components without a parameter are
  /// dropped. Throws Error(bad_input) for unknown queries and for words that the turtle cannot
  /// read.
  void answer(const System& system, Word& drawn) const override;

 private:
  TurtleOptions options_;
  std::optional<field::Field> field_;
};

}  // namespace vug::lsystem
