// What a turtle meets on its way: the answers to the queries of a word.
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
  /// Without a field ?D says that everything is free: a distance of 1e6 m and no gradient.
  explicit TurtleEnvironment(TurtleOptions options, std::optional<field::Field> field = {})
      : options_(std::move(options)), field_(std::move(field)) {}

  /// ?P, ?H, ?L, ?U and ?D as Environment says; of what a query has no parameter for, it is not
  /// told. Error(bad_input) for queries of other names, and where the turtle cannot read the word.
  void answer(const System& system, Word& drawn) const override;

 private:
  TurtleOptions options_;
  std::optional<field::Field> field_;
};

}  // namespace vug::lsystem
