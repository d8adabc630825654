// `grammar NAME: lsystem { ... }` of a scene: the system, its turtle, and what that draws.
#pragma once

#include <vug/field/field.h>
#include <vug/lsystem/derive.h>
#include <vug/lsystem/options.h>
#include <vug/lsystem/turtle.h>
#include <vug/shot/shot.h>

#include <mutex>

namespace vug::shot {

/// The entries of an L-system's block, beside its axiom and rules.
struct LSystemBlock : lsystem::SystemOptions, lsystem::TurtleOptions {
  std::optional<field::Field> field;  ///< What ?D asks for.
};
const Schema<LSystemBlock>& lsystem_schema();

/// Immutable; Shot::lsystems are of these. Errors are those of lsystem::derive and lsystem::draw.
class LSystemPlan {
 public:
  /// `max_memory`: bytes of a word, 0 for what the machine can give.
  LSystemPlan(std::string plan_name, lsystem::SystemPtr of, LSystemBlock with, uint64_t max_memory)
      : name(std::move(plan_name)),
        system(std::move(of)),
        block(std::move(with)),
        max_memory_(max_memory) {}

  const std::string name;
  const lsystem::SystemPtr system;
  const LSystemBlock block;

  /// The word after the block's steps or at its time, or those given: its turtle answers queries.
  lsystem::Derivation derive(std::optional<int> steps = {}, std::optional<double> time = {}) const;
  /// Such a word as the turtle reads it.
  lsystem::Word interpret(lsystem::Derivation derivation) const;
  /// What is drawn of that, made when it is first asked for.
  lsystem::DrawingPtr drawing() const;
  /// The same, made anew.
  lsystem::Drawing draw() const;

 private:
  std::optional<uint64_t> memory() const;

  uint64_t max_memory_;
  mutable std::once_flag once_;
  mutable lsystem::DrawingPtr drawing_;
};

}  // namespace vug::shot

namespace vug {

template <>
struct ValueTraits<shot::LSystemPtr> : ObjectTraits<shot::LSystemPtr> {
  static constexpr const char* kWord = "lsystem";
};

}  // namespace vug
