// SPDX-License-Identifier: Apache-2.0
// The plan of a `grammar NAME: lsystem { ... }`: the L-system, its turtle settings and its drawing.
#pragma once

#include <vug/field/field.h>
#include <vug/lsystem/derive.h>
#include <vug/lsystem/options.h>
#include <vug/lsystem/turtle.h>
#include <vug/shot/shot.h>

#include <mutex>

namespace vug::shot {

/// The entries of an L-system's block other than its axiom and rules.
struct LSystemBlock : lsystem::SystemOptions, lsystem::TurtleOptions {
  std::optional<field::Field> field;  ///< The solid queried by ?D.
};
const Schema<LSystemBlock>& lsystem_schema();

/// An immutable L-system, the element of Shot::lsystems. Throws the errors of lsystem::derive and
/// lsystem::draw.
class LSystemPlan {
 public:
  /// `max_memory`: limit for a word in bytes; 0: the machine's free memory.
  LSystemPlan(std::string plan_name, lsystem::SystemPtr of, LSystemBlock with, uint64_t max_memory)
      : name(std::move(plan_name)),
        system(std::move(of)),
        block(std::move(with)),
        max_memory_(max_memory) {}

  const std::string name;
  const lsystem::SystemPtr system;
  const LSystemBlock block;

  /// The word after the given steps or at the given time, by default those of the block. Its turtle
  /// answers queries.
  lsystem::Derivation derive(std::optional<int> steps = {}, std::optional<double> time = {}) const;
  /// The word after interpretation rules, as the turtle reads it.
  lsystem::Word interpret(lsystem::Derivation derivation) const;
  /// The drawing of that word, computed on first use.
  lsystem::DrawingPtr drawing() const;
  /// The drawing, computed again.
  lsystem::Drawing draw() const;

 private:
  std::optional<uint64_t> memory() const;

  uint64_t max_memory_;
  mutable std::mutex computing_;
  mutable lsystem::DrawingPtr drawing_;
};

}  // namespace vug::shot

namespace vug {

template <>
struct ValueTraits<shot::LSystemPtr> : ObjectTraits<shot::LSystemPtr> {
  static constexpr const char* kWord = "lsystem";
};

}  // namespace vug
